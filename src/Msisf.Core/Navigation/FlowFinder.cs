using Msisf.Core.Camera;
using Msisf.Core.Parallel;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Scene;
using Msisf.Core.Tracing;

namespace Msisf.Core.Navigation;

/// <summary>
/// Finds where the surface points of a frame lie in another one. What hides a point from the other camera is found as a shadow is: by the
/// frame drawn again with a light in the other camera's place. So it is right on the surface of this frame, whatever level of detail the
/// other one has.
/// </summary>
/// <param name="frame">The frame; its camera has one state for all rows.</param>
public sealed class FlowFinder(IGroundTruth frame, FrameRedraw redraw)
{
    /// <summary>m above the highest ground, from where on a light may be placed.</summary>
    private const double Clear = 1.0;

    /// <summary>The flow.</summary>
    public FlowField Find(FlowTarget target, int threads, CancellationToken cancellation)
    {
        FlowField flow = new(frame.Camera.Width, frame.Camera.Height);
        FrameCamera other = target.Camera;
        using NativeFrame? seen = other.PositionBodyFixed.Length > redraw.Terrain.RadiusLimits.Max + Clear
            ? redraw.With(new SceneLight(other.PositionBodyFixed, IsSun: true), SunModel.Point, threads, cancellation)
            : null;
        TerrainTracer? tracer = seen is null ? new TerrainTracer(redraw.Terrain) : null;
        bool isRelit = target.Light.IsSun && frame.Light.IsSun && target.Light.PositionBodyFixed != frame.Light.PositionBodyFixed;
        using NativeFrame? relit = isRelit ? redraw.With(target.Light, redraw.Sun, threads, cancellation) : null;
        TruthRow[][] rows = [.. Enumerable.Range(0, threads).Select(_ => (TruthRow[])[new(), new(), new()])];
        WorkerTeam.Run(
            threads,
            flow.Height,
            (worker, row) =>
            {
                TruthRow[] own = rows[worker];
                frame.ReadRow(row + 1, own[0]);
                Read(seen, row + 1, own[1]);
                Read(relit, row + 1, own[2]);
                FindPlaces(flow, row, own[0], other);
                FindClasses(flow, row, own[0], other, seen is null ? null : own[1], tracer);
                FindLights(flow, row, own[0], relit is null ? own[0] : own[2], target.Light);
            },
            cancellation);
        return flow;
    }

    private void Read(NativeFrame? drawn, int y, TruthRow row)
    {
        if (drawn is not null)
        {
            ((IGroundTruth)drawn).ReadRow(y + redraw.Margin, row);
            row.Cut(redraw.Margin, frame.Camera.Width);
        }
    }

    private static void FindPlaces(FlowField flow, int row, TruthRow points, FrameCamera other)
    {
        int start = row * flow.Width;
        flow.Right.AsSpan(start, flow.Width).Fill(double.NaN);
        flow.Down.AsSpan(start, flow.Width).Fill(double.NaN);
        for (int i = 0; i < points.Points.Count; i++)
        {
            int column = points.Points.Columns[i];
            if (other.TryProjectPoint(points.PointAt(i), out RenderingPoint at))
            {
                flow.Right[start + column] = at.X - (column + 1);
                flow.Down[start + column] = at.Y - (row + 1);
            }
        }
    }

    private static void FindClasses(
        FlowField flow, int row, TruthRow points, FrameCamera other, TruthRow? seen, TerrainTracer? tracer)
    {
        int start = row * flow.Width;
        for (int i = 0; i < points.Points.Count; i++)
        {
            int column = points.Points.Columns[i];
            double x = column + 1 + flow.Right[start + column];
            double y = row + 1 + flow.Down[start + column];
            bool isInside = x >= 0.5 && x <= other.Width + 0.5 && y >= 0.5 && y <= other.Height + 0.5; // false without a place
            flow.Classes[start + column] = (byte)(!isInside ? FlowClass.Outside
                : IsSeen(i) ? FlowClass.Seen
                : FlowClass.Hidden);
        }

        bool IsSeen(int index) => seen is null
            ? !tracer!.IsHidden(points.PointAt(index), points.Facets[index], other.PositionBodyFixed)
            : seen.Lights[index].VisibleFraction > 0.0;
    }

    /// <summary>A facet that turns away from the Sun of the frame in which it is dark is dark by its slope.</summary>
    private void FindLights(FlowField flow, int row, TruthRow points, TruthRow relit, SceneLight otherLight)
    {
        int start = row * flow.Width;
        Vector3D light = frame.Light.PositionBodyFixed;
        for (int i = 0; i < points.Points.Count; i++)
        {
            bool isLit = points.Lights[i].VisibleFraction > 0.0;
            bool isLitThere = relit.Lights[i].VisibleFraction > 0.0;
            Vector3D source = isLit ? otherLight.PositionBodyFixed : light;
            flow.Lights[start + points.Points.Columns[i]] = (byte)(isLit == isLitThere
                ? isLit ? FlowLight.LitInBoth : FlowLight.DarkInBoth
                : Vector3D.Dot(redraw.NormalOf(points.Facets[i]), source - points.PointAt(i)) > 0.0 ? FlowLight.ChangedByShadow
                : FlowLight.ChangedBySlope);
        }
    }
}

/// <summary>The other frame of a flow.</summary>
public sealed record FlowTarget(FrameCamera Camera, SceneLight Light);

/// <summary>Where the surface points of a frame's pixels lie in another frame. Arrays by rows, a number for each pixel.</summary>
/// <param name="Width">px.</param>
/// <param name="Height">px.</param>
public sealed record FlowField(int Width, int Height)
{
    /// <summary>px: to the right, from the pixel's centre to the point's place in the other frame; NaN where there is none.</summary>
    public double[] Right { get; } = new double[Width * Height];

    /// <summary>px: down.</summary>
    public double[] Down { get; } = new double[Width * Height];

    /// <summary><see cref="FlowClass"/>: what the other frame shows of the points.</summary>
    public byte[] Classes { get; } = new byte[Width * Height];

    /// <summary><see cref="FlowLight"/>: how the light on the points differs.</summary>
    public byte[] Lights { get; } = new byte[Width * Height];
}

/// <summary>What another frame shows of a surface point; the numbers are those of the files.</summary>
public enum FlowClass : byte
{
    /// <summary>The pixel shows no surface.</summary>
    NoSurface = 0,

    /// <summary>The other frame shows the point.</summary>
    Seen = 1,

    /// <summary>Its place lies inside the other image, but its facet faces away, or terrain lies in front of it.</summary>
    Hidden = 2,

    /// <summary>Its place lies outside the other image, or it lies behind that camera.</summary>
    Outside = 3,
}

/// <summary>How the light on a surface point differs in two frames; the numbers are those of the files.</summary>
public enum FlowLight : byte
{
    /// <summary>The pixel shows no surface.</summary>
    NoSurface = 0,

    /// <summary>Some of the Sun shines on it in both.</summary>
    LitInBoth = 1,

    /// <summary>None in either.</summary>
    DarkInBoth = 2,

    /// <summary>Dark in one, because terrain is between it and the Sun.</summary>
    ChangedByShadow = 3,

    /// <summary>Dark in one, because its facet faces away from the Sun.</summary>
    ChangedBySlope = 4,
}
