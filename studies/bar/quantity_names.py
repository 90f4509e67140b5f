"""The measured quantities of a Taylor impact, in the order in which they are reported."""

QUANTITIES = (
    "final_length",
    "foot_radius",
    "rim_lift",
    "radius_at_0.2_L0",
    "undeformed_length",
    "profile_arc_length",
    "profile_area",
    "volume",
    "centroid_r",
    "centroid_z",
    "max_equivalent_plastic_strain",
    "max_temperature",
    "contact_duration",
)

LEADING = ("final_length", "foot_radius", "rim_lift", "max_equivalent_plastic_strain", "max_temperature")
