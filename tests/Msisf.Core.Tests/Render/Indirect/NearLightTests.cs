using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Tracing;
using Xunit;

namespace Msisf.Core.Tests.Render.Indirect;

/// <summary>The light of ground that is too near for the points that stand for it, against its closed form.</summary>
public sealed class NearLightTests
{
    /// <summary>m: of the peaks, and from vertex to vertex.</summary>
    private const double Peak = 4.0;
    private const double Scale = 4.0;

    /// <summary>Vertices from peak to peak: so far apart that hardly any stands before another.</summary>
    private const int Apart = 80;

    /// <summary>
    /// All light comes from peaks of one vertex, that few of a pixel's first rays meet: those that meet none must not take the pixel for
    /// dark.
    /// </summary>
    [Fact]
    public void Render_SmallPeaksBesidePixels_HaveTheLightOfTheClosedForm()
    {
        const double Albedo = 0.3;
        const double Elevation = 80.0; // all sides of peaks are lit
        const double Width = 640.0; // m, of the image
        const double Error = 0.1;
        PlaneGrid grid = new(Scale, 201, (x, y) => IsPeak(x) && IsPeak(y) ? Peak : 0.0);
        NativeRenderOptions options = PlaneView.Options(Albedo) with { Indirect = new IndirectLight(1, Error) };
        using NativeFrame frame = PlaneView.Draw(grid, Elevation, 16, options, width: Width);

        (double sine, double cosine) = Math.SinCos(double.DegreesToRadians(Elevation));
        Vector3D toSun = new(cosine, 0.0, sine);
        (double squares, double wrong, int count) = (0.0, 0.0, 0);
        foreach ((int pixel, SurfaceHit hit, _) in PlaneView.Within(frame, Width))
        {
            Vector3D point = hit.PointBodyFixed - (PlaneView.Radius * Vector3D.UnitZ);
            if (double.Hypot(Beside(point.X), Beside(point.Y)) < Width / 16)
            {
                double expected = Albedo * Albedo * FromPeaks(point, toSun);
                (squares, count) = (squares + (expected * expected), count + 1);
                wrong += (frame.IndirectFactors[pixel] - expected) * (frame.IndirectFactors[pixel] - expected);
            }
        }

        Assert.Equal(16, count);
        Assert.InRange(Math.Sqrt(wrong / squares), 0.0, Error);
    }

    /// <summary>m from the nearest line of peaks.</summary>
    private static double Beside(double coordinate) => Math.IEEERemainder(coordinate - (0.5 * Apart * Scale), Apart * Scale);

    private static bool IsPeak(double coordinate) => ((int)Math.Round(coordinate / Scale) + (50 * Apart)) % Apart == Apart / 2;

    /// <summary>The light of all peaks' facets over that of the Sun on a plane across its rays.</summary>
    private static double FromPeaks(Vector3D point, Vector3D toSun)
    {
        (int Down, int Right)[] around = [(1, 0), (1, 1), (0, 1), (-1, 0), (-1, -1), (0, -1)]; // diagonals from north-west to south-east
        double sum = 0.0;
        for (int line = -100; line <= 100; line++)
        {
            for (int sample = -100; sample <= 100; sample++)
            {
                if (!IsPeak(line * Scale) || !IsPeak(sample * Scale))
                {
                    continue;
                }

                Vector3D top = new Vector3D(line * Scale, sample * Scale, Peak) - point;
                for (int side = 0; side < around.Length; side++)
                {
                    Vector3D[] corners = [top, Foot(around[side]), Foot(around[(side + 1) % around.Length])];
                    Vector3D normal = Vector3D.Cross(corners[1] - top, corners[2] - top).Normalized();
                    double incidence = Vector3D.Dot(normal, toSun);
                    if (incidence > 0.0 && Vector3D.Dot(normal, top) < 0.0)
                    {
                        sum += incidence * PlaneView.PartOf(corners, Vector3D.UnitZ);
                    }
                }

                Vector3D Foot((int Down, int Right) step) => top + new Vector3D(step.Down * Scale, step.Right * Scale, -Peak);
            }
        }

        return sum;
    }
}
