using System.Runtime.InteropServices;
using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Scene;
using Msisf.Core.Tracing;

namespace Msisf.Core.Tests.Support;

/// <summary>All that a frame says, kept for a comparison to the last bit.</summary>
/// <param name="RadianceFactors">Bits of each pixel's I/F.</param>
/// <param name="Truth">What each pixel's centre shows, and its light; null where that is no surface.</param>
internal sealed record FrameValues(IReadOnlyList<long> RadianceFactors, IReadOnlyList<(SurfaceHit Hit, PixelIllumination Light)?> Truth)
{
    /// <summary>Draws a frame and gives it back.</summary>
    public static FrameValues Of(NativeRenderer renderer, ICamera camera, SceneLight light, NativeRenderOptions options, int threads)
    {
        using NativeFrame frame = renderer.Render(camera, light, options, threads);
        return Of(frame);
    }

    /// <summary>Reads a frame.</summary>
    public static FrameValues Of(NativeFrame frame)
    {
        int width = frame.Camera.Width;
        (SurfaceHit, PixelIllumination)?[] truth = new (SurfaceHit, PixelIllumination)?[width * frame.Camera.Height];
        for (int pixel = 0; pixel < truth.Length; pixel++)
        {
            truth[pixel] = frame.TryGet((pixel % width) + 1, (pixel / width) + 1, out SurfaceHit hit, out PixelIllumination light)
                ? (hit, light)
                : null;
        }

        return new FrameValues(MemoryMarshal.Cast<double, long>(frame.RadianceFactors).ToArray(), truth);
    }

    public bool Equals(FrameValues? other) =>
        other is not null && RadianceFactors.SequenceEqual(other.RadianceFactors) && Truth.SequenceEqual(other.Truth);

    public override int GetHashCode() => RadianceFactors.Count;
}
