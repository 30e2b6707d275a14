"""JSON Schemas of the command line's --json output: build() writes them as one file.

They describe exactly one version: unknown keys are refused. A later version may print more keys, and has schemas for
them. Keys are never renamed.
"""

from ev3proto.generate.output_schemas.build import FILE_NAME, build

__all__ = ["FILE_NAME", "build"]
