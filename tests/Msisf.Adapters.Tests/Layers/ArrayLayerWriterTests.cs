using System.Text;
using System.Text.Json;
using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Core.Camera;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Layers;

public sealed class ArrayLayerWriterTests : IDisposable
{
    private static readonly Vector3D Sun = new(1.5e11, 1e10, 0.0);

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Write_Mask_IsAnArrayFileOfNumPy()
    {
        // A camera far enough that the corners of 3 x 3 px show space; numpy.lib.format has the head: 64-byte aligned, padded with blanks.
        List<string> paths = Write("mask", new Vector3D(4e6, 0.0, 0.0));

        byte[] file = File.ReadAllBytes(paths[0]);

        Assert.Equal(_folder["frame.mask.npy"], paths[0]);
        Assert.Equal(
            "\u0093NUMPY\u0001\0\u0076\0{'descr': '|u1', 'fortran_order': False, 'shape': (3, 3,), }",
            Encoding.Latin1.GetString(file)[..70]);
        Assert.Equal((byte)'\n', file[127]);
        Assert.Equal([0, 1, 0, 1, 1, 1, 0, 1, 0], file[128..]);
    }

    [Fact]
    public void Write_Vector_HasItsNumbersSideBySide()
    {
        byte[] file = File.ReadAllBytes(Write("normal", new Vector3D(4e6, 0.0, 0.0))[0]);

        const int centre = 128 + (4 * 3 * sizeof(double));
        Assert.Equal(128 + (27 * sizeof(double)), file.Length);
        Assert.Equal(1.0, BitConverter.ToDouble(file, centre));
        Assert.Equal(0.0, BitConverter.ToDouble(file, centre + sizeof(double)));
        Assert.True(double.IsNaN(BitConverter.ToDouble(file, 128)));
    }

    [Fact]
    public void Write_Provenance_ReadsBackToTheBit()
    {
        List<string> paths = Write("tile,depth", new Vector3D(4e6 / 3.0, 0.0, 3e6));

        using JsonDocument json = JsonDocument.Parse(File.ReadAllText(paths[^1]));

        int Whole(string name) => json.RootElement.GetProperty(name).GetInt32();
        Assert.Equal(["frame.depth.npy", "frame.tile.npy", "frame.layers.json"], paths.Select(Path.GetFileName));
        Assert.Equal(4e6 / 3.0, json.RootElement.GetProperty("cameraPositionM")[0].GetDouble());
        Assert.Equal("--x '\u00e4'", json.RootElement.GetProperty("commandLine").GetString());
        Assert.Equal((16, 4), (Whole("pixelsPerDegree"), Whole("meshPixelsPerDegree")));
        Assert.Equal(1234.5, json.RootElement.GetProperty("heightOverTerrainM").GetDouble());
        Assert.Equal("depth", json.RootElement.GetProperty("layers")[0].GetProperty("name").GetString());
    }

    [Fact]
    public void Write_Camera_ProjectsThePositionsOntoTheirPixels()
    {
        List<string> paths = Write("position", new Vector3D(2e6, 0.0, 0.0));
        byte[] positions = File.ReadAllBytes(paths[0]);

        using JsonDocument json = JsonDocument.Parse(File.ReadAllText(paths[^1]));
        double[][] k = Rows(json.RootElement.GetProperty("K"));
        double[][] r = Rows(json.RootElement.GetProperty("R"));
        double[] t = Row(json.RootElement.GetProperty("t"));

        Assert.Equal((3, 3), (json.RootElement.GetProperty("width").GetInt32(), json.RootElement.GetProperty("height").GetInt32()));
        for (int pixel = 0; pixel < 9; pixel++)
        {
            double[] point = [.. Enumerable.Range(0, 3).Select(
                axis => BitConverter.ToDouble(positions, 128 + (((3 * pixel) + axis) * sizeof(double))))];
            double[] seen = [.. r.Zip(t, (row, shift) => Dot(row, point) + shift)];
            Assert.Equal(pixel % 3, Dot(k[0], seen) / Dot(k[2], seen), Rounding.OfPlaces);
            Assert.Equal(pixel / 3, Dot(k[1], seen) / Dot(k[2], seen), Rounding.OfPlaces);
        }
    }

    private static double[][] Rows(JsonElement matrix) => [.. matrix.EnumerateArray().Select(Row)];

    private static double[] Row(JsonElement row) => [.. row.EnumerateArray().Select(number => number.GetDouble())];

    private static double Dot(double[] a, double[] b) => a.Zip(b, (x, y) => x * y).Sum();

    private List<string> Write(string layers, Vector3D position)
    {
        PinholeCamera camera = new(position, UnitQuaternion.Identity, 1.0, 3, 3);
        FrameMetadata frame = new(
            Moments.OfMjd(55289.25),
            camera,
            57.0,
            Sun,
            new DrawnElevation("LDEM_16", IsSynthetic: false, 16, 4, 4),
            1234.5,
            "1.0.0",
            "--x '\u00e4'",
            RendererKind.Native,
            []);
        using AtomicFileSet files = new();
        List<string> paths = [];
        ArrayLayerWriter.Write(
            files.Under(_folder["frame"], paths), frame,
            new LayerProvenance("LDEM_16", 4, 2, "native", SpectralBand.Default), new SphereTruth(camera,
                Sun, 4),
            LayerSet.Parse(layers));
        files.Commit();
        return paths;
    }
}
