"""Heat from plastic work."""
