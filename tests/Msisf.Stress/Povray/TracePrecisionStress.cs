using System.Globalization;
using Msisf.Adapters.Tiles;
using Msisf.Core.Numerics;
using Msisf.Core.Tiles;
using Msisf.TestSupport;

namespace Msisf.Stress.Povray;

/// <summary>POV-Ray's own precision: hits of its <c>trace()</c> on patterns against the exact facets.</summary>
public sealed class TracePrecisionStress : IStressTest
{
    /// <summary>Half a unit in the last place of a 32-bit float near 1, in which POV-Ray keeps a triangle's normal and distance.</summary>
    internal const double FloatUnit = 1.0 / (1 << 24);

    /// <summary>
    /// Of <see cref="FloatUnit"/> times the distance from the tile's origin: each component of the normal is wrong by half a unit at most
    /// (sqrt(3)/2 in all), the distance of the plane, which is shorter, by half.
    /// </summary>
    internal const double MaxFromPlaneInFloats = 1.4;

    /// <summary>m: that, 130 km from the tile's origin, where a tile at the equator has its corners and mountains are 20 km high.</summary>
    internal const double MaxFromPlane = 0.011;

    /// <summary>Degrees: sqrt(3)/2 of <see cref="FloatUnit"/>, the rounding of the three components.</summary>
    internal const double MaxNormalDegrees = 3.0e-6;

    private static readonly int[] Resolutions = [4, 16, 64, 256, 1024];

    /// <inheritdoc/>
    public string Name => "pov-ray-trace";

    /// <inheritdoc/>
    public string Subject =>
        "POV-Ray's own precision: random rays from 10 m to 4e8 m away, up to 87 degrees from the normal, "
            + "through the inside of facets of rugged ground, by trace() on tile-local mesh2 patterns and on the thesis's absolute mesh, "
            + "against the exact facet.";

    /// <inheritdoc/>
    public string? MissingPart => TestParts.Program("povray") is null ? "POV-Ray" : null;

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        bool isFull = length == StressLength.Full;
        (int blocks, int cells, int rays) = isFull ? (10, 64, 1000) : (2, 20, 150);
        TraceErrors local = new("tile-local mesh2");
        TraceErrors absolute = new("the thesis's mesh");
        foreach ((int part, int pixelsPerDegree) in Resolutions.Index())
        {
            RunResolution(pixelsPerDegree, new CaseRandom(seed, part), blocks, cells, rays, local, absolute);
        }

        return new StressReport(
            Name,
            Resolutions.Length * blocks * rays,
            [.. local.Figures(isLimited: true), .. absolute.Figures(isLimited: false)],
            [.. local.Series(), .. absolute.Series()]);
    }

    private static void RunResolution(
        int pixelsPerDegree, CaseRandom random, int blockCount, int cells, int raysOfBlock, TraceErrors local, TraceErrors absolute)
    {
        using TemporaryFolder folder = new();
        FunctionGrid grid = FunctionGrid.Rugged(pixelsPerDegree);
        TileMeshBuilder builder = new(grid);
        TileId[] tiles = [.. TileId.All];
        PovRayTrace trace = new(folder.Path);
        List<(TraceBlock Block, TraceRay Ray)> asked = [];
        for (int number = 0; number < blockCount; number++)
        {
            TraceBlock block = new(builder, grid, TraceBlock.Layout(tiles[random.Below(tiles.Length)], pixelsPerDegree, cells, random));
            string localName = Declare(trace, block, folder, PatternFormat.Mesh2, number);
            string absoluteName = Declare(trace, block, folder, PatternFormat.Mesh, number);
            for (int i = 0; i < raysOfBlock; i++)
            {
                TraceRay ray = block.Draw(random);
                trace.Add(localName, ray.StartKm, ray.Direction);
                trace.Add(absoluteName, ray.StartKm, ray.Direction);
                asked.Add((block, ray));
            }
        }

        (Vector3D PointKm, Vector3D Normal)[] answers = trace.Run();
        if (answers.Length != 2 * asked.Count)
        {
            throw new InvalidOperationException($"POV-Ray answered {answers.Length} of {2 * asked.Count} rays.");
        }

        foreach ((int i, (TraceBlock block, TraceRay ray)) in asked.Index())
        {
            local.Note(block, pixelsPerDegree, ray, answers[2 * i].PointKm, answers[2 * i].Normal);
            absolute.Note(block, pixelsPerDegree, ray, answers[(2 * i) + 1].PointKm, answers[(2 * i) + 1].Normal);
        }
    }

    private static string Declare(PovRayTrace trace, TraceBlock block, TemporaryFolder folder, PatternFormat format, int number)
    {
        string name = string.Create(CultureInfo.InvariantCulture, $"{format}{number}");
        string path = folder[name + ".inc"];
        block.Write(path, format);
        trace.Declare(name, [path]);
        return name;
    }
}
