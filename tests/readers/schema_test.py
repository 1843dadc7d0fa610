"""schema_test.py SETTLE SOURCES: an independent JSON Schema validator takes `settle schema`, accepts every shipped case and
campaign, and refuses what the programs refuse, as far as a schema can know.
"""
import json
import pathlib
import subprocess
import sys
import tomllib
import unittest

try:
    import jsonschema
except ImportError:
    print("skipped: python3-jsonschema is not installed")
    sys.exit(77)

settle, sources = sys.argv[1], pathlib.Path(sys.argv[2])

# What only the programs can know: keys that contradict each other, and names that have to be in the same file.
beyond_a_schema = {
    "attraction_beyond_preconsolidation", "band_upside_down", "compared_with_itself",
    "control_of_nothing_known", "convergence_of_an_unknown_solver", "convergence_over_fields", "damped_motion",
    "embankment_all_foundation", "embankment_with_a_support", "embankment_without_measures", "everything_removed",
    "exact_of_a_field", "exact_that_is_no_number", "failure_held_for_a_time", "failure_of_a_column",
    "failure_of_a_known_motion", "failure_of_a_refilled_fill", "failure_under_relaxation",
    "fields_against_the_exact_solution",
    "fields_of_a_column", "formula_unfinished", "formula_with_a_slip", "ground_under_a_fill",
    "hold_before_anything", "k0_in_a_valley", "k0_of_a_fill", "layer_never_placed", "layer_of_two_materials",
    "layer_placed_twice", "layer_removed_before_it_is_there", "layer_without_polygon", "layers_backwards",
    "layers_that_are_not_there", "level_given_twice", "levels_from_fine_to_coarse", "levels_of_nothing",
    "levels_that_do_not_match", "levels_without_element_size", "line_that_is_not_fitted", "load_in_space_on_a_section",
    "load_on_a_point", "load_on_nothing", "load_without_a_load", "measures_of_an_embankment", "mesh_file_that_is_not_there",
    "mesh_left_out", "mesh_of_another_version", "mesh_of_polygons", "mesh_of_triangles",
    "mesh_with_a_size_of_its_own", "mesh_with_a_support", "mesh_with_too_few_layers", "mesh_without_the_group",
    "missing_key", "more_dilation_than_friction", "motion_in_space", "motion_of_a_solid_column", "motion_under_way",
    "neither_cohesion_nor_friction", "order_left_out", "order_of_divergence", "path_of_a_column",
    "paths_of_different_lengths", "point_in_layers", "point_with_a_support", "point_without_a_path",
    "polygon_clockwise", "polygon_of_an_unknown_material", "polygon_with_a_dent", "polygons_that_overlap",
    "polygons_without_support", "probe_beside_the_depth", "probe_outside", "probes_beside_the_polygons",
    "probes_in_the_flank", "probes_of_a_section_in_a_valley", "probes_of_a_valley_in_a_section",
    "reference_called_exact", "refilled_motion", "region_of_a_column", "region_of_a_mass",
    "relaxation_for_a_time", "second_meaning_of_x", "stage_of_no_layer", "stages_of_a_column", "strength_left_out",
    "strength_of_an_elastic_law", "strength_of_nothing", "support_of_a_column", "support_of_a_mass",
    "support_of_no_motion", "support_that_is_not_there", "swelling_beyond_compression", "two_levels_of_layers",
    "undefined_material", "valley_in_the_plane", "valley_of_a_column", "valley_with_a_depth",
    "valley_with_a_foundation", "valley_without_width",
}


def validator(kind):
    schema = json.loads(subprocess.run([settle, "schema", kind], check=True, capture_output=True, text=True).stdout)
    of_draft = jsonschema.validators.validator_for(schema, default=None)
    of_draft.check_schema(schema)
    return of_draft(schema)


schemas = {kind: validator(kind) for kind in ("case", "campaign")}


def complaints(kind, document):
    """What the validator says of a document; of what no JSON can hold (nan, dates), that."""
    try:
        document = json.loads(json.dumps(document, allow_nan=False))
    except (TypeError, ValueError) as error:
        return [f"not JSON: {error}"]
    return [f"{'.'.join(map(str, error.absolute_path))}: {error.message}" for error in schemas[kind].iter_errors(document)]


def refused(kind, text):
    return complaints(kind, tomllib.loads(text)) != []


class Schema(unittest.TestCase):
    def test_every_shipped_case_and_campaign_is_accepted(self):
        kinds = {"case": 0, "campaign": 0}
        for path in sorted((sources / "cases").rglob("*.toml")):
            document = tomllib.loads(path.read_text())
            kind = "campaign" if "run" in document else "case"
            kinds[kind] += 1
            with self.subTest(file=str(path.relative_to(sources))):
                self.assertEqual(complaints(kind, document), [])
        self.assertTrue(all(kinds.values()), kinds)

    def test_every_invalid_case_is_refused_unless_no_schema_could(self):
        paths = sorted((sources / "tests" / "invalid").glob("*.toml"))
        self.assertLessEqual(beyond_a_schema, {path.stem for path in paths})
        for path in paths:
            try:
                document = tomllib.loads(path.read_text())
            except tomllib.TOMLDecodeError:
                continue
            with self.subTest(file=path.name):
                self.assertEqual(complaints("case", document) == [], path.stem in beyond_a_schema, complaints("case", document))

    def test_names_that_people_choose_are_held_to_their_letters(self):
        text = (sources / "cases" / "paper" / "refill.toml").read_text().replace("[material.fill]", "[material.\"fi/ll\"]")
        self.assertTrue(refused("case", text))

    def test_what_is_shown_with_all_defaults_is_accepted(self):
        for path in sorted((sources / "cases" / "paper").glob("refill*.toml")):
            shown = subprocess.run([settle, "show", path], check=True, capture_output=True, text=True).stdout
            self.assertEqual(complaints("case", tomllib.loads(shown)), [], path)

    def test_mistakes_in_campaigns_are_refused(self):
        run = "format = 1\n[[run]]\nname = \"a\"\ncase = \"a.toml\"\n"
        self.assertFalse(refused("campaign", run + "matrix.construction.layers = [5, 10]\nset.\"fem.element_size\" = 0.5"))
        for mistake in ["solver = [\"mpm\"]", "solvers = []", "solvers = \"mpm\"", "time_limit = 0", "converge = 1",
                        "matrix.\"construction.layers\" = 5", "matrix.\"construction.layers\" = []", "set = 1",
                        "[[figure]]\ntitle = \"without a name\"", "[figure]\nname = \"not a list\"", "[publised]"]:
            with self.subTest(mistake=mistake):
                self.assertTrue(refused("campaign", run + mistake))


unittest.main(argv=sys.argv[:1])
