using Msisf.Core.Numerics;
using Msisf.Core.Render.Shadows;

namespace Msisf.Core.Tests.Render.Shadows;

/// <summary>Given points as an image of so many columns.</summary>
internal sealed class PointReceivers(IReadOnlyList<Vector3D> points, int width) : IReceiverRows
{
    public int Rows => (points.Count + width - 1) / width;

    public int Width => width;

    public int Read(int row, Span<double> x, Span<double> y, Span<double> z, Span<int> columns)
    {
        int count = Math.Min(width, points.Count - (row * width));
        for (int column = 0; column < count; column++)
        {
            (x[column], y[column], z[column]) = points[(row * width) + column];
            columns[column] = column;
        }

        return count;
    }

    public void ReadAgain(int row, ReadOnlySpan<int> columns, Span<double> x, Span<double> y, Span<double> z)
    {
        for (int i = 0; i < columns.Length; i++)
        {
            (x[i], y[i], z[i]) = points[(row * width) + columns[i]];
        }
    }
}
