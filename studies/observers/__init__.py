"""What hangs on a run's loop, one observer per file."""
