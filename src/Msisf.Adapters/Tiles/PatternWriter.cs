using Msisf.Core.Mesh;
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

    /// <summary>Writes a pattern.</summary>
    /// <param name="output">A stream that can seek; the pattern begins at its position.</param>
    /// <param name="mesh">The mesh.</param>
    /// <param name="productId">PRODUCT_ID of the elevation model.</param>
    /// <param name="format">The form of the mesh.</param>
    public static void Write(Stream output, TileMesh mesh, string productId, PatternFormat format) =>
        Write(output, mesh, PatternHeader.WithoutLength(mesh.Layout, mesh.Radii, mesh.SkirtFootRadius, productId, format), format);

    /// <summary>Writes a pattern whose header is known.</summary>
    internal static void Write(Stream output, TileMesh mesh, byte[] headerWithoutLength, PatternFormat format)
    {
        long start = output.Position;
        AsciiWriter writer = new(output);
        writer.Write(headerWithoutLength);
        writer.Write(0, PatternHeader.LengthDigits);
        writer.Write("\n"u8);
        if (format == PatternFormat.Mesh2)
        {
            WriteMesh2(writer, mesh);
        }
        else
        {
            WriteMesh(writer, mesh);
        }

        writer.Flush();
        WriteLength(output, start + headerWithoutLength.Length, writer.Length);
    }

    /// <summary>
    /// Writes whole steps, scaled by the local k = 2^-17: exact as 32-bit floats, and of the size of kilometres. Without the factor POV-Ray
    /// 3.7 would see nothing from more than 10^7 steps = 78 km away (its MAX_DISTANCE counts in the mesh's own units).
    /// </summary>
    private static void WriteMesh2(AsciiWriter writer, TileMesh mesh)
    {
        writer.Write("#local k=1/131072;\nmesh2{\nvertex_vectors{"u8);
        writer.Write(mesh.VertexCount);
        for (int i = 0; i < mesh.Offsets.Length; i += 3)
        {
            writer.Write(",\n"u8);
            writer.WriteVector(mesh.Offsets[i], mesh.Offsets[i + 1], mesh.Offsets[i + 2]);
            writer.Write("*k"u8);
        }

        writer.Write("}\nface_indices{"u8);
        writer.Write(mesh.FaceCount);
        for (int i = 0; i < mesh.Faces.Length; i += 3)
        {
            writer.Write(",\n"u8);
            writer.WriteVector(mesh.Faces[i], mesh.Faces[i + 1], mesh.Faces[i + 2]);
        }

        LatticePoint origin = mesh.Origin;
        writer.Write("}\ntranslate "u8);
        writer.WriteVector(origin.X, origin.Y, origin.Z);
        writer.Write("*k\nscale 1.024\ntexture{moon}\n}\n"u8);
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

    private static void WriteLength(Stream output, long position, long length)
    {
        long end = output.Position;
        output.Position = position;
        AsciiWriter writer = new(output);
        writer.Write(length, PatternHeader.LengthDigits);
        writer.Flush();
        output.Position = end;
    }
}
