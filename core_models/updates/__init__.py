"""Stress updates: hypoelastic-plastic, hyperelastic-plastic, and elasticity alone."""
