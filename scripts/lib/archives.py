#!/usr/bin/env python3
"""Packs a folder with the program as a zip file, as a package for pip, or as one for `dotnet tool`. The same files give the same bytes.

    archives.py zip TREE FILE
    archives.py wheel TREE FOLDER PLATFORM
    archives.py tool TREE FOLDER VERSION SYSTEM
    archives.py tools FOLDER VERSION SYSTEM...     the package that names those for each system
"""

import os
import pathlib
import sys
import time
import zipfile

NAME = 'msisf'
COMMAND = 'msis'
CLIENT = pathlib.Path(__file__).resolve().parents[2] / 'clients' / 'python'
TYPES = (
    '<?xml version="1.0" encoding="utf-8"?>\n<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
    '<Default Extension="nuspec" ContentType="application/octet" /><Default Extension="rels" '
    'ContentType="application/vnd.openxmlformats-package.relationships+xml" />{}</Types>\n'
)
RELATIONS = (
    '<?xml version="1.0" encoding="utf-8"?>\n<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
    '<Relationship Type="http://schemas.microsoft.com/packaging/2010/07/manifest" Target="/{}.nuspec" Id="R1" /></Relationships>\n'
)
NUSPEC = """<?xml version="1.0" encoding="utf-8"?>
<package xmlns="http://schemas.microsoft.com/packaging/2012/06/nuspec.xsd">
  <metadata>
    <id>{}</id>
    <version>{}</version>
    <authors>The MSISF authors</authors>
    <description>Synthetic images of the Moon for optical navigation.</description>
    <packageTypes>
      <packageType name="{}" />
    </packageTypes>
  </metadata>
</package>
"""
SETTINGS = """<?xml version="1.0" encoding="utf-8"?>
<DotNetCliTool Version="2">
  <Commands>
    <Command Name="{}"{} />
  </Commands>{}
</DotNetCliTool>
"""


def files_of(tree):
    """Path within the tree -> content and mode. These packages know no links: in place of one to a program is a script that starts it."""
    paths = sorted(path for path in pathlib.Path(tree).rglob('*') if path.is_file())
    return {path.relative_to(tree).as_posix(): (content_of(path), path.stat().st_mode & 0o777) for path in paths}


def content_of(path):
    return f'#!/bin/sh\nexec "${{0%/*}}/{path.readlink()}" "$@"\n'.encode() if path.is_symlink() else path.read_bytes()


def write_zip(path, files):
    stamp = time.gmtime(max(int(os.environ['SOURCE_DATE_EPOCH']), 315532800))[:6]  # a zip file has no time before 1980
    with zipfile.ZipFile(path, 'w', zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, (content, mode) in files.items():
            entry = zipfile.ZipInfo(name, stamp)
            entry.external_attr = (0o100000 | mode) << 16
            entry.create_system = 3  # Unix, whose modes these are
            archive.writestr(entry, content, zipfile.ZIP_DEFLATED)


def zip_tree(tree, path):
    write_zip(path, {f'{pathlib.Path(tree).name}/{name}': file for name, file in files_of(tree).items()})


def wheel(tree, folder, platform):
    sys.path.insert(0, str(CLIENT))
    import build_backend

    build_backend.build_wheel_with_program(pathlib.Path(folder), files_of(tree), platform)


def tool(tree, folder, version, system):
    """The program of one system. Its settings name the file to be started, beside them; for any system .NET starts it."""
    start, runner = (f'{COMMAND}.exe' if system.startswith('win-') else COMMAND), 'executable'
    if system == 'any':
        start, runner = f'{NAME}.dll', 'dotnet'
    place = f'tools/any/{system}'
    files = {f'{place}/{name}': file for name, file in files_of(tree).items()}
    settings = SETTINGS.format(COMMAND, f' EntryPoint="{start}" Runner="{runner}"', '')
    write_tool(folder, f'{NAME}.{system}', version, 'DotnetToolRidPackage', f'{place}/DotnetToolSettings.xml', settings, files)


def tools(folder, version, *systems):
    lines = ''.join(f'\n    <RuntimeIdentifierPackage RuntimeIdentifier="{system}" Id="{NAME}.{system}" />' for system in systems)
    listed = f'\n  <RuntimeIdentifierPackages>{lines}\n  </RuntimeIdentifierPackages>'
    settings = SETTINGS.format(COMMAND, '', listed)
    write_tool(folder, NAME, version, 'DotnetTool', 'tools/net10.0/any/DotnetToolSettings.xml', settings, {})


def write_tool(folder, name, version, kind, place, settings, files):
    endings = sorted({pathlib.PurePosixPath(path).suffix.lstrip('.') for path in [*files, place]} - {''})
    bare = [path for path in files if not pathlib.PurePosixPath(path).suffix]
    types = ''.join(f'<Default Extension="{ending}" ContentType="application/octet" />' for ending in endings) + ''.join(
        f'<Override PartName="/{path}" ContentType="application/octet" />' for path in bare
    )
    texts = {
        '[Content_Types].xml': TYPES.format(types),
        '_rels/.rels': RELATIONS.format(name),
        f'{name}.nuspec': NUSPEC.format(name, version, kind),
        place: settings,
    }
    write_zip(
        pathlib.Path(folder) / f'{name}.{version}.nupkg', {path: (text.encode(), 0o644) for path, text in texts.items()} | files
    )


if __name__ == '__main__':
    {'zip': zip_tree, 'wheel': wheel, 'tool': tool, 'tools': tools}[sys.argv[1]](*sys.argv[2:])
