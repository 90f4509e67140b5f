"""What accuracy costs: time, work and memory of every variant of both methods to reach given errors."""
