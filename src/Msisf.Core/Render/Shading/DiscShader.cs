using System.Collections.Concurrent;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Shading;

/// <summary>
/// Turns the hidden points of the Sun's disc into each pixel's visible fraction and mean cosine. Safe for several threads.
/// </summary>
internal sealed class DiscShader
{
    private readonly ConcurrentBag<SurfaceRow> _rows = [];

    /// <summary>Completes the light of a frame.</summary>
    /// <param name="visible">What the pixels show.</param>
    /// <param name="disc">The Sun.</param>
    /// <param name="sunlight">Hidden points are known, and cosines to the disc's centre; the rest is filled.</param>
    /// <param name="threads">At most.</param>
    /// <param name="cancellation">Ends the work.</param>
    public void Run(VisibleSurface visible, SunDisc disc, PixelSunlight sunlight, int threads, CancellationToken cancellation) =>
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
        VisibleSurface visible, SunDisc disc, int row, Span<double> cosines, Span<double> fractions, Span<byte> hidden,
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
