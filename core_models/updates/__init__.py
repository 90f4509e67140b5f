"""Stress updates: hypoelastic-plastic, hyperelastic-plastic, and compressible neo-Hookean elasticity."""
