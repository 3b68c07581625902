using System.Globalization;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Layers;

/// <summary>
/// A line of tests/golden/layers.tsv: a scene and what tests/reference/layers.py (mpmath, 50 digits) found on the reference sphere.
/// </summary>
internal sealed record ReferenceLayers(string Scene, PinholeCamera Camera, int X, int Y, Vector3D Sun, IReadOnlyList<double> Values)
{
    /// <summary>The layers whose values the line holds, in this order; a vector has three.</summary>
    public static readonly string[] Names = ["depth", "range", "position", "height", "incidence", "emission", "phase", "pixel-scale"];

    public static ReferenceLayers[] Read()
    {
        ReferenceLayers[] all = [.. File.ReadLines(Path.Combine(TestParts.RepositoryRoot, "tests", "golden", "layers.tsv"))
            .Where(line => line[0] != '#')
            .Select(line => line.Split('\t'))
            .Select(Parse)];
        Assert.NotEmpty(all);
        return all;
    }

    private static ReferenceLayers Parse(string[] fields)
    {
        double[] n = [.. fields.Skip(1).Select(field => double.Parse(field, CultureInfo.InvariantCulture))];
        PinholeCamera camera = new(
            new Vector3D(n[0], n[1], n[2]), UnitQuaternion.FromComponents(n[3], n[4], n[5], n[6]), n[7], (int)n[8], (int)n[9]);
        return new ReferenceLayers(fields[0], camera, (int)n[10], (int)n[11], new Vector3D(n[12], n[13], n[14]), n[15..]);
    }
}
