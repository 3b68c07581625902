using System.Collections.Concurrent;
using Msisf.Core.Parallel;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Shading;

/// <summary>
/// Computes the visible fraction of the Sun's disc and the mean cosine of the incidence angle for each pixel. Safe for several threads.
/// </summary>
internal sealed class DiscShader
{
    private readonly ConcurrentBag<SurfaceRow> _rows = [];

    /// <summary>Completes the light on the pixels of a frame.</summary>
    /// <param name="visible">The surface points that the pixels show.</param>
    /// <param name="sunlight">Has hidden points and cosines to the disc's centre; gets fractions, hidden flags and mean cosines.</param>
    public void Run(ISurfaceRows visible, SunDisc disc, PixelSunlight sunlight, int threads, CancellationToken cancellation) =>
        WorkerTeam.Run(threads, visible.Height, (_, row) =>
        {
            int start = row * visible.Width;
            Span<double> cosines = sunlight.CosIncidence.AsSpan(start, visible.Width);
            Span<double> fractions = sunlight.VisibleFractions.AsSpan(start, visible.Width);
            Span<byte> hidden = sunlight.Hidden.AsSpan(start, visible.Width);
            ReadOnlySpan<ulong> points = sunlight.HiddenPoints.AsSpan(start, visible.Width);
            bool hasParts = false;
            for (int column = 0; column < cosines.Length; column++)
            {
                bool isWhole = points[column] == 0 && !disc.IsCut(cosines[column]);
                bool isDark = !disc.MayLight(cosines[column]) || points[column] == SunDisc.All;
                fractions[column] = isWhole && !isDark ? 1.0 : 0.0;
                hidden[column] = isDark ? (byte)1 : (byte)0;
                hasParts |= !isWhole && !isDark;
            }

            if (hasParts)
            {
                FindParts(visible, disc, row, cosines, fractions, hidden, points);
            }
        }, cancellation);

    private void FindParts(
        ISurfaceRows visible, SunDisc disc, int row, Span<double> cosines, Span<double> fractions, Span<byte> hidden,
        ReadOnlySpan<ulong> points)
    {
        SurfaceRow pixels = _rows.TryTake(out SurfaceRow? idle) ? idle : new SurfaceRow();
        visible.Read(row + 1, pixels);
        for (int i = 0; i < pixels.Count; i++)
        {
            int column = pixels.Columns[i];
            if (fractions[column] > 0.0 || hidden[column] != 0)
            {
                continue;
            }

            DiscLight light = disc.LightAt(
                new Vector3D(pixels.X[i], pixels.Y[i], pixels.Z[i]),
                new Vector3D(pixels.NormalX[i], pixels.NormalY[i], pixels.NormalZ[i]),
                points[column]);
            fractions[column] = light.VisibleFraction;
            hidden[column] = light.VisibleFraction > 0.0 ? (byte)0 : (byte)1;
            cosines[column] = light.VisibleFraction > 0.0 ? light.Irradiance / light.VisibleFraction : 0.0;
        }

        _rows.Add(pixels);
    }
}
