using System.Runtime.Intrinsics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Tells which cells of a block lie wholly beyond one side of a part of the image. It works for corners behind the camera too: a side is a
/// plane through the camera, and no point of a facet whose corners all lie beyond it is seen on the inner side.
/// </summary>
internal sealed class WindowSides
{
    private const int Sides = 4;

    /// <summary>px beyond the outermost pixels' centres, so that no rounding of a projection leads across a side.</summary>
    private const double Margin = 2.0;

    /// <summary>Part of the products of a plane's normal with a position that is more than their rounding.</summary>
    private const double Rounding = 1e-12;

    private readonly ulong[][] _beyond = [.. Enumerable.Range(0, Sides).Select(_ => new ulong[CellBlock.Size + 1])];

    /// <summary>Looks at the vertices of a block.</summary>
    /// <param name="vertices">Its vertices, relative to <see cref="ImageView.Origin"/>.</param>
    /// <param name="view">The projection.</param>
    /// <param name="window">The part of the image.</param>
    /// <param name="margin">px: maximum distance of a sample from its pixel along columns or rows.</param>
    public void Find(BlockVertices vertices, ImageView view, in PixelRange window, double margin)
    {
        double more = Margin + margin;
        Find(0, vertices, view, view.Across + ((view.CentreX - window.FirstColumn + more) * view.Forward));
        Find(1, vertices, view, ((window.LastColumn + more - view.CentreX) * view.Forward) - view.Across);
        Find(2, vertices, view, view.Down + ((view.CentreY - window.FirstRow + more) * view.Forward));
        Find(3, vertices, view, ((window.LastRow + more - view.CentreY) * view.Forward) - view.Down);
    }

    /// <summary>The cells of a line of the block that may be seen, as bits from the left.</summary>
    public uint CellsOfLine(int line)
    {
        ulong gone = 0;
        foreach (ulong[] beyond in _beyond)
        {
            ulong both = beyond[line] & beyond[line + 1];
            gone |= both & (both >> 1);
        }

        return (uint)~gone;
    }

    /// <summary>Finds the vertices beyond one side, where the dot product with its inward normal is below 0.</summary>
    private void Find(int side, BlockVertices vertices, ImageView view, Vector3D inward)
    {
        Vector512<double> normalX = Vector512.Create(inward.X);
        Vector512<double> normalY = Vector512.Create(inward.Y);
        Vector512<double> normalZ = Vector512.Create(inward.Z);
        Vector512<double> atCamera = Vector512.Create(Vector3D.Dot(inward, view.Remainder));
        Vector512<double> rounding = Vector512.Create(-Rounding * inward.Length);
        ulong[] beyond = _beyond[side];
        for (int line = 0; line < vertices.Lines; line++)
        {
            ulong bits = 0;
            for (int sample = 0; sample < vertices.Samples; sample += Vector512<double>.Count)
            {
                int at = (line * BlockVertices.Stride) + sample;
                Vector512<double> x = ArrayLanes.Load(vertices.X, at);
                Vector512<double> y = ArrayLanes.Load(vertices.Y, at);
                Vector512<double> z = ArrayLanes.Load(vertices.Z, at);
                Vector512<double> inside = ((x * normalX) + (y * normalY) + (z * normalZ)) - atCamera;
                Vector512<double> limit = rounding * (Vector512<double>.One + Vector512.Abs(x) + Vector512.Abs(y) + Vector512.Abs(z));
                bits |= (ulong)Vector512.LessThan(inside, limit).ExtractMostSignificantBits() << sample;
            }

            beyond[line] = bits;
        }
    }
}
