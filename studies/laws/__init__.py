"""The material laws as text and as data, and a sample of each."""
