# SPDX-License-Identifier: MIT
"""Holds cases/case.schema.json against the case files that the loader is tested with, and
cases/gallery.schema.json and cases/policy.schema.json against the suite's galleries, policies and profiles.

The schema of cases must accept every good case and all of cases/, and refuse every file of bad/. Files of
bad_loader_only/ are those that no schema can refuse: they are no JSON at all, or the schema accepts
them. Were one of them refused, it would belong to bad/.
"""
import json
import math
import pathlib
import unittest

from jsonschema import Draft202012Validator

HERE = pathlib.Path(__file__).resolve().parent
CASES = HERE.parent.parent / "cases"
SCHEMA = json.loads((CASES / "case.schema.json").read_text(encoding="utf-8"))
VALIDATOR = Draft202012Validator(SCHEMA)
LEAST_BAD_FILES = 60
GALLERIES = sorted((CASES / "galleries").glob("*.json"))
GALLERY_SCHEMA = json.loads((CASES / "gallery.schema.json").read_text(encoding="utf-8"))
GALLERY_VALIDATOR = Draft202012Validator(GALLERY_SCHEMA)
POLICIES = sorted([*(CASES / "policies").glob("*.json"), *(CASES / "profiles").glob("*.json")])
POLICY_SCHEMA = json.loads((CASES / "policy.schema.json").read_text(encoding="utf-8"))
POLICY_VALIDATOR = Draft202012Validator(POLICY_SCHEMA)


class NotJson(Exception):
    """The text is no JSON document of which a schema could judge the values."""


def refuse(word):
    raise NotJson(f"{word} is no JSON")


def finite(digits):
    if not math.isfinite(float(digits)):
        raise NotJson(f"{digits} is beyond a double")
    return float(digits)


def without_repetition(pairs):
    names = [name for name, _ in pairs]
    if len(set(names)) != len(names):
        raise NotJson("a key stands twice")
    return dict(pairs)


def parse(file):
    try:
        return json.loads(file.read_bytes().decode("utf-8"), parse_constant=refuse,
                          parse_float=finite, object_pairs_hook=without_repetition)
    except ValueError as error:
        raise NotJson(str(error)) from error


def faults(file):
    return [f"{error.json_path}: {error.message}" for error in VALIDATOR.iter_errors(parse(file))]


def is_case(file):
    folders = {part.name for part in file.relative_to(CASES).parents}
    other = {"known", "policies", "profiles", "galleries"}
    return not file.name.endswith(".schema.json") and not folders & other


def properties_of(schema):
    """All named properties and definitions of a schema, however deep."""
    if isinstance(schema, dict):
        for key, value in schema.items():
            if key in ("properties", "$defs") and isinstance(value, dict):
                yield from value.items()
            yield from properties_of(value)
    elif isinstance(schema, list):
        for value in schema:
            yield from properties_of(value)


class SchemaTest(unittest.TestCase):
    def test_schema_is_valid(self):
        Draft202012Validator.check_schema(SCHEMA)

    def test_everything_is_described(self):
        for name, schema in properties_of(SCHEMA):
            with self.subTest(name):
                self.assertTrue("description" in schema or "$ref" in schema)

    def test_accepts_good_cases(self):
        files = sorted((HERE / "good").glob("*.json"))
        self.assertGreaterEqual(len(files), 10)
        for file in files:
            with self.subTest(file.name):
                self.assertEqual(faults(file), [])

    def test_accepts_the_suite(self):
        for file in sorted(filter(is_case, CASES.rglob("*.json"))):
            with self.subTest(str(file.relative_to(CASES))):
                self.assertEqual(faults(file), [])

    def test_refuses_bad_cases(self):
        files = sorted((HERE / "bad").glob("*.json"))
        self.assertGreaterEqual(len(files), LEAST_BAD_FILES)
        for file in files:
            with self.subTest(file.name):
                self.assertNotEqual(faults(file), [])

    def test_cannot_refuse_what_is_left_to_the_loader(self):
        for file in sorted((HERE / "bad_loader_only").glob("*.json")):
            with self.subTest(file.name):
                try:
                    self.assertEqual(faults(file), [])
                except NotJson:
                    pass


class GallerySchemaTest(unittest.TestCase):
    def test_schema_is_valid(self):
        Draft202012Validator.check_schema(GALLERY_SCHEMA)

    def test_accepts_the_suite(self):
        self.assertGreaterEqual(len(GALLERIES), 5)
        for file in GALLERIES:
            with self.subTest(file.name):
                errors = GALLERY_VALIDATOR.iter_errors(parse(file))
                self.assertEqual([error.message for error in errors], [])

    def test_refuses_what_the_loader_refuses(self):
        good = {"title": "t", "policy": "p", "pictures": [{"case": "a", "heading": "b"}]}
        self.assertTrue(GALLERY_VALIDATOR.is_valid(good))
        picture = good["pictures"][0]
        for wrong in ({"title": ""}, {"title": "a\tb"}, {"policy": 1}, {"pictures": []},
                      {"pictures": [{"case": "a"}]}, {"pictures": [picture | {"rule": {}}]},
                      {"pictures": [picture | {"rules": {"Snap": "none"}}]},
                      {"pictures": [picture] * 101}, {"choices": {"snap": "x"}},
                      {"choices": {"line.snap": ""}}, {"not_shown": []}, {"sources": "x"},
                      {"caption": "x"}):
            with self.subTest(wrong):
                self.assertFalse(GALLERY_VALIDATOR.is_valid(good | wrong))


class PolicySchemaTest(unittest.TestCase):
    def test_schema_is_valid(self):
        Draft202012Validator.check_schema(POLICY_SCHEMA)

    def test_accepts_the_suite(self):
        self.assertGreaterEqual(len(POLICIES), 12)
        for file in POLICIES:
            with self.subTest(file.name):
                errors = POLICY_VALIDATOR.iter_errors(parse(file))
                self.assertEqual([error.message for error in errors], [])

    def test_refuses_what_the_loader_refuses(self):
        good = {"name": "p", "rules": {"line.snap": "none"},
                "surfaces": {"fbo": {"triangle.fill-rule": "left-top"}}}
        self.assertTrue(POLICY_VALIDATOR.is_valid(good))
        for wrong in ({"name": ""}, {"name": "a\tb"}, {"latitude": "all"}, {"rules": []},
                      {"rules": {"line.snaps": "none"}}, {"rules": {"line.snap": "nonce"}},
                      {"rules": {"line.snap": 1}}, {"surfaces": {"pbuffer": {}}},
                      {"surfaces": {"fbo": {"line.snap": ""}}}, {"why": 1}, {"choices": {}}):
            with self.subTest(wrong):
                self.assertFalse(POLICY_VALIDATOR.is_valid(good | wrong))
        self.assertFalse(POLICY_VALIDATOR.is_valid({"rules": {}}))


if __name__ == "__main__":
    unittest.main()
