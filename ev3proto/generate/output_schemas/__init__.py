"""JSON Schemas of what the command line prints with --json: build() writes them as one file.

They describe one version exactly: a key that they do not have is refused. A later version may print more keys, and then
its schemas have those. None is renamed.
"""

from ev3proto.generate.output_schemas.build import FILE_NAME, build

__all__ = ["FILE_NAME", "build"]
