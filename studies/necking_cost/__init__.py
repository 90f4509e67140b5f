"""What implicit necking costs: time against degrees of freedom, and beside CalculiX."""
