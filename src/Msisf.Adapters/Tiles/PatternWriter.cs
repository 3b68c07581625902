using Msisf.Core.Blocks;
using Msisf.Core.Surface;
using Msisf.Core.Tiles;

namespace Msisf.Adapters.Tiles;

/// <summary>
/// Writes a tile's mesh as a pattern file for POV-Ray: the same mesh always gives the same bytes (docs/pattern-format.md).
/// </summary>
public static class PatternWriter
{
    /// <summary>1e10 / 128 000: a lattice step in units of 1e-10 km, exactly.</summary>
    private const long StepInDecimals = 78125;

    private const long DecimalsInKilometre = 10_000_000_000;

    /// <summary>2^10 m are a unit of a mesh.</summary>
    private const int UnitExponent = 10;

    /// <summary>
    /// Number of vertices of a mesh up to which the text of each number is made once and copied for each triangle: far more than a block
    /// has, and no more memory than its text takes.
    /// </summary>
    private const int MaxTexts = 1 << 16;

    /// <summary>Steps of 2^-7 m.</summary>
    private const int TileLatticeExponent = 7;

    /// <summary>Writes a pattern.</summary>
    /// <param name="output">A stream that can seek; the pattern begins at its position.</param>
    /// <param name="productId">PRODUCT_ID of the elevation model.</param>
    /// <param name="format">The form of the mesh.</param>
    public static void Write(Stream output, TileMesh mesh, string productId, PatternFormat format) =>
        Write(output, mesh, PatternHeader.WithoutLength(mesh.Layout, mesh.Radii, productId, format), format);

    /// <summary>Writes a pattern of a block whose header is known.</summary>
    /// <param name="output">As above.</param>
    /// <param name="isOneSided">Whether the facets are met from outside only, because there are ways to their other side.</param>
    internal static void Write(Stream output, IReadOnlyList<BlockMesh> meshes, byte[] headerWithoutLength, bool isOneSided) => Write(
        output,
        headerWithoutLength,
        writer =>
        {
            foreach (BlockMesh mesh in meshes)
            {
                WriteMesh2(writer, mesh.Offsets, mesh.Faces, mesh.Origin, mesh.LatticeExponent, isOneSided, isInSceneAxes: true);
            }
        });

    /// <summary>Writes a pattern whose header is known.</summary>
    internal static void Write(Stream output, TileMesh mesh, byte[] headerWithoutLength, PatternFormat format) => Write(
        output,
        headerWithoutLength,
        writer =>
        {
            if (format == PatternFormat.Mesh2)
            {
                LatticePoint origin = mesh.Origin;
                WriteMesh2(
                    writer, mesh.Offsets, mesh.Faces, (origin.X, origin.Y, origin.Z), TileLatticeExponent, isOneSided: false,
                    isInSceneAxes: false);
            }
            else
            {
                WriteMesh(writer, mesh);
            }
        });

    private static void Write(Stream output, byte[] headerWithoutLength, Action<AsciiWriter> writeMesh)
    {
        using AsciiWriter writer = new(output);
        writer.Write(headerWithoutLength);
        writer.Write(0, PatternHeader.LengthDigits);
        writer.Write("\n"u8);
        writeMesh(writer);
        writer.WriteOver(headerWithoutLength.Length, writer.Length, PatternHeader.LengthDigits);
        writer.Flush();
    }

    /// <summary>
    /// Writes whole steps of 2^-n m, scaled by the local k = 2^(-10 - n): exact as 32-bit floats, and in units of 1.024 km. Without the
    /// factor POV-Ray 3.7 would see nothing from more than 10^7 steps = 78 km away (its MAX_DISTANCE counts in the mesh's own units).
    /// </summary>
    /// <remarks>What POV-Ray calls the inside is the side from which the corners are counter-clockwise.</remarks>
    private static void WriteMesh2(
        AsciiWriter writer, int[] offsets, int[] faces, (long X, long Y, long Z) origin, int latticeExponent, bool isOneSided,
        bool isInSceneAxes)
    {
        writer.Write("#local k=1/"u8);
        writer.Write(1L << (UnitExponent + latticeExponent));
        writer.Write(";\nmesh2{\nvertex_vectors{"u8);
        writer.Write(offsets.Length / 3);
        for (int i = 0; i < offsets.Length; i += 3)
        {
            writer.Write(",\n"u8);
            writer.WriteVector(offsets[i], offsets[i + 1], offsets[i + 2]);
            writer.Write("*k"u8);
        }

        writer.Write("}\nface_indices{"u8);
        writer.Write(faces.Length / 3);
        WriteFaces(writer, faces, offsets.Length / 3, isOneSided);
        writer.Write("}\ntranslate "u8);
        writer.WriteVector(origin.X, origin.Y, origin.Z);
        writer.Write("*k\nscale 1.024\n"u8);
        writer.Write(isInSceneAxes ? "translate -Origin\nscale UnitsPerKilometre\n"u8 : ""u8);
        writer.Write("texture{moon}\n"u8);
        writer.Write(isOneSided ? "interior_texture{pigment{rgbt 1}}\n"u8 : ""u8);
        writer.Write("}\n"u8);
    }

    private static void WriteFaces(AsciiWriter writer, int[] faces, int vertices, bool isOneSided)
    {
        (int second, int third) = isOneSided ? (2, 1) : (1, 2);
        ulong[] texts = vertices <= MaxTexts ? AsciiWriter.TextsOfNumbers(vertices) : [];
        for (int i = 0; i < faces.Length; i += 3)
        {
            writer.Write(",\n"u8);
            if (texts.Length > 0)
            {
                writer.WriteVectorOfTexts(texts[faces[i]], texts[faces[i + second]], texts[faces[i + third]]);
            }
            else
            {
                writer.WriteVector(faces[i], faces[i + second], faces[i + third]);
            }
        }
    }

    private static void WriteMesh(AsciiWriter writer, TileMesh mesh)
    {
        writer.Write("mesh {\n"u8);
        for (int i = 0; i < mesh.Faces.Length; i += 3)
        {
            writer.Write("triangle {\n"u8);
            WriteKilometres(writer, mesh.Vertex(mesh.Faces[i]));
            writer.Write(", "u8);
            WriteKilometres(writer, mesh.Vertex(mesh.Faces[i + 1]));
            writer.Write(", "u8);
            WriteKilometres(writer, mesh.Vertex(mesh.Faces[i + 2]));
            writer.Write("\ntexture { moon }\n}\n"u8);
        }

        writer.Write("}\n"u8);
    }

    private static void WriteKilometres(AsciiWriter writer, LatticePoint point)
    {
        writer.Write("<"u8);
        WriteKilometres(writer, point.X);
        writer.Write(", "u8);
        WriteKilometres(writer, point.Y);
        writer.Write(", "u8);
        WriteKilometres(writer, point.Z);
        writer.Write(">"u8);
    }

    private static void WriteKilometres(AsciiWriter writer, int steps)
    {
        long decimals = Math.Abs(steps * StepInDecimals);
        writer.Write(steps < 0 ? "-"u8 : ""u8);
        writer.Write(decimals / DecimalsInKilometre, digits: 1);
        writer.Write("."u8);
        writer.Write(decimals % DecimalsInKilometre, digits: 10);
    }
}

/// <summary>How a pattern file writes its mesh (docs/pattern-format.md).</summary>
public enum PatternFormat
{
    /// <summary>POV-Ray's mesh2 with whole lattice steps: exact, the default.</summary>
    Mesh2,

    /// <summary>
    /// POV-Ray's mesh with one triangle after the other in kilometres, as in the thesis: larger, and rounded to 0.1 m by POV-Ray.
    /// </summary>
    Mesh,
}
