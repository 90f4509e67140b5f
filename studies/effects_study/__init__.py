"""What a scene's effects cost and change, next to what its own numbers had said beforehand."""
