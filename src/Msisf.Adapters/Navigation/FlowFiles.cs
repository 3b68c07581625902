using System.Buffers.Binary;
using Msisf.Adapters.Render;
using Msisf.Core.Navigation;

namespace Msisf.Adapters.Navigation;

/// <summary>Writes flows in the formats of optical flow's benchmarks.</summary>
public static class FlowFiles
{
    /// <summary>px: what Middlebury's readers take as unknown.</summary>
    private const float Unknown = 1e10f;

    /// <summary>px: KITTI's numbers reach from -512 to below 512.</summary>
    private const double KittiLimit = 512.0;

    /// <summary>Steps of a pixel in KITTI's flow.</summary>
    private const double KittiSteps = 64.0;

    /// <summary>Steps of a pixel in KITTI's disparity.</summary>
    private const double DisparitySteps = 256.0;

    private const int KittiBits = 16;

    /// <summary>Writes Middlebury's .flo: single precision, unknown where the point has no place in the other image.</summary>
    /// <param name="stream">Receives the file; stays open.</param>
    public static void WriteMiddlebury(Stream stream, FlowField flow)
    {
        Span<byte> head = stackalloc byte[12];
        "PIEH"u8.CopyTo(head);
        BinaryPrimitives.WriteInt32LittleEndian(head[4..], flow.Width);
        BinaryPrimitives.WriteInt32LittleEndian(head[8..], flow.Height);
        stream.Write(head);
        byte[] row = new byte[8 * flow.Width];
        for (int y = 0; y < flow.Height; y++)
        {
            for (int x = 0; x < flow.Width; x++)
            {
                int pixel = (y * flow.Width) + x;
                bool isKnown = double.IsFinite(flow.Right[pixel]);
                BinaryPrimitives.WriteSingleLittleEndian(row.AsSpan(8 * x), isKnown ? (float)flow.Right[pixel] : Unknown);
                BinaryPrimitives.WriteSingleLittleEndian(row.AsSpan((8 * x) + 4), isKnown ? (float)flow.Down[pixel] : Unknown);
            }

            stream.Write(row);
        }
    }

    /// <summary>Writes KITTI's flow: 16-bit colours, valid where the point is seen and both parts are below 512 px.</summary>
    /// <param name="stream">Receives the file; stays open.</param>
    public static void WriteKitti(Stream stream, FlowField flow)
    {
        ushort[] colors = new ushort[3 * flow.Classes.Length];
        for (int i = 0; i < flow.Classes.Length; i++)
        {
            double right = Math.Round(flow.Right[i] * KittiSteps);
            double down = Math.Round(flow.Down[i] * KittiSteps);
            if (flow.Classes[i] == (byte)FlowClass.Seen && IsWithin(right) && IsWithin(down))
            {
                colors[3 * i] = (ushort)(right + (KittiLimit * KittiSteps));
                colors[(3 * i) + 1] = (ushort)(down + (KittiLimit * KittiSteps));
                colors[(3 * i) + 2] = 1;
            }
        }

        PngWriter.WriteColors(stream, colors, flow.Width);
    }

    /// <summary>Writes KITTI's disparity: 16-bit grey in steps of 1/256 px, 0 where it is hidden, outside, or 256 px and more.</summary>
    /// <param name="stream">Receives the file; stays open.</param>
    /// <param name="flow">The flow to the right camera.</param>
    public static void WriteKittiDisparity(Stream stream, FlowField flow)
    {
        ushort[] levels = new ushort[flow.Classes.Length];
        for (int i = 0; i < levels.Length; i++)
        {
            double steps = Math.Round(-flow.Right[i] * DisparitySteps);
            levels[i] = flow.Classes[i] == (byte)FlowClass.Seen && steps >= 1.0 && steps <= ushort.MaxValue ? (ushort)steps : (ushort)0;
        }

        PngWriter.WriteNumbers(stream, levels, flow.Width, KittiBits);
    }

    private static bool IsWithin(double steps) => steps >= -KittiLimit * KittiSteps && steps < KittiLimit * KittiSteps;
}
