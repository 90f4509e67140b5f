"""The studies of `matpoint study`, one small module each, with its options and what it prints."""
