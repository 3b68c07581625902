using System.Text;
using System.Text.Json;
using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Core.Camera;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Layers;

public sealed class NpyLayerWriterTests : IDisposable
{
    private static readonly Vector3D Sun = new(1.5e11, 1e10, 0.0);

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Write_Mask_IsAnArrayFileOfNumPy()
    {
        // A camera far enough that the corners of 3 x 3 px show space; numpy.lib.format has the head: 64-byte aligned, padded with blanks.
        IReadOnlyList<string> paths = Write("mask", new Vector3D(4e6, 0.0, 0.0));

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
        IReadOnlyList<string> paths = Write("tile,depth", new Vector3D(4e6 / 3.0, 0.0, 3e6));

        using JsonDocument json = JsonDocument.Parse(File.ReadAllText(paths[^1]));

        Assert.Equal(["frame.depth.npy", "frame.tile.npy", "frame.layers.json"], paths.Select(Path.GetFileName));
        Assert.Equal(4e6 / 3.0, json.RootElement.GetProperty("cameraPositionM")[0].GetDouble());
        Assert.Equal("--x '\u00e4'", json.RootElement.GetProperty("commandLine").GetString());
        Assert.Equal(4, json.RootElement.GetProperty("meshPixelsPerDegree").GetInt32());
        Assert.Equal("depth", json.RootElement.GetProperty("layers")[0].GetProperty("name").GetString());
    }

    private IReadOnlyList<string> Write(string layers, Vector3D position)
    {
        PinholeCamera camera = new(position, UnitQuaternion.Identity, 1.0, 3, 3);
        FrameMetadata frame = new(new ModifiedJulianDate(55289.25), camera, 57.0, Sun, 16, "1.0.0", "--x '\u00e4'");
        using AtomicFileSet files = new();
        IReadOnlyList<string> paths = NpyLayerWriter.Write(
            files, _folder["frame"], frame, new LayerProvenance("LDEM_16", 4, 2, "native", SpectralBand.Default), new SphereTruth(camera, Sun, 4),
            LayerSet.Parse(layers));
        files.Commit();
        return paths;
    }
}
