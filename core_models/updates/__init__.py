"""Stress updates: hypoelastic-plastic and hyperelastic-plastic."""
