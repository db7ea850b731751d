"""Columns of the archive's tables (docs/archive.md), and their units."""

UNITS = {
    "trial": "",
    "id": "",
    "parent": "",
    "generation": "",
    "age": "generations",
    "valid": "",
    "fitness": "body lengths",
    "displacement_y_voxels": "voxels",
    "displacement_xy_voxels": "voxels",
    "first_top_contact_since_birth_s": "s",
    "fell_over_since_birth_s": "s",
    "turns": "full turns",
    "airborne_fraction": "1",
    "morphology_window": "1",
    "control_window": "1",
    "state_hash": "",
    "phenotype_hash": "",
    "genome_hash": "",
    "champion": "",
    "best_fitness": "body lengths",
    "median_fitness": "body lengths",
    "rank": "",
    "ancestor": "",
    "generations": "",
    "finished": "",
    "individuals": "",
    "invalid": "",
}

MEASURES = (  # of an evaluation, as numbers
    "fitness",
    "displacement_y_voxels",
    "displacement_xy_voxels",
    "first_top_contact_since_birth_s",
    "fell_over_since_birth_s",
    "turns",
    "airborne_fraction",
)
RIGID_MEASURES = (  # the same of a rigid body
    "fitness",
    "descent",
    "sideways",
    "turns",
    "airborne_fraction",
    "abdomen_contact",
    "leg_contact",
    "first_abdomen_contact_since_birth_s",
    "first_roll_since_birth_s",
)
WINDOWS = ("morphology_window", "control_window")
INDIVIDUAL_COLUMNS = ("trial", "id", "parent", "generation", "age", "valid") + MEASURES + WINDOWS
RIGID_INDIVIDUAL_COLUMNS = ("trial", "id", "parent", "generation", "age", "valid") + RIGID_MEASURES + WINDOWS
HASH_COLUMNS = ("state_hash", "phenotype_hash", "genome_hash")
GENOME_COLUMNS = ("size_gene_initial", "size_gene_final", "phase_initial", "phase_final", "mutation_rate")
RIGID_GENOME_COLUMNS = ("leg_length_initial", "leg_length_final", "weight_initial", "weight_final", "mutation_rate")
RIGID_UNITS = {
    **UNITS,
    "fitness": "1/m^2",
    "best_fitness": "1/m^2",
    "median_fitness": "1/m^2",
    "descent": "m",
    "sideways": "m",
    "abdomen_contact": "1",
    "leg_contact": "1",
    "first_abdomen_contact_since_birth_s": "s",
    "first_roll_since_birth_s": "s",
}
