"""What a failed point still carries."""
