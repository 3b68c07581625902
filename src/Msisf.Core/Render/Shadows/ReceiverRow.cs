using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Shadows;

/// <summary>The receivers of one row of the image; one object is used for many rows.</summary>
internal sealed class ReceiverRow
{
    private static readonly int Lanes = Vector512<double>.Count;

    public int Count { get; private set; }

    /// <summary>Maximum number of receivers: the image's number of columns.</summary>
    public int Width { get; private set; }

    /// <summary>
    /// Coordinate in light space, m (in MOON_ME before <see cref="ToLight"/>). The arrays have whole vectors, with zeros after the last
    /// receiver.
    /// </summary>
    public double[] U { get; private set; } = [];

    /// <inheritdoc cref="U"/>
    public double[] V { get; private set; } = [];

    /// <inheritdoc cref="U"/>
    public double[] W { get; private set; } = [];

    /// <summary>Column of the image of each receiver.</summary>
    public int[] Columns { get; private set; } = [];

    /// <summary>A width rounded up to whole vectors.</summary>
    public static int Padded(int width) => (width + Lanes - 1) / Lanes * Lanes;

    /// <summary>Reads the receivers of a row, in MOON_ME.</summary>
    /// <param name="receivers">The receivers of the image.</param>
    /// <param name="row">Row of the image.</param>
    public void Read(IReceiverRows receivers, int row)
    {
        EnsureWidth(receivers.Width);
        Count = receivers.Read(row, U.AsSpan(0, Width), V.AsSpan(0, Width), W.AsSpan(0, Width), Columns.AsSpan(0, Width));
        Pad();
    }

    /// <summary>Reads the marked receivers of a row that was read before, in MOON_ME.</summary>
    /// <param name="receivers">The receivers of the image.</param>
    /// <param name="row">Row of the image.</param>
    /// <param name="grid">Knows which are marked.</param>
    /// <param name="start">Where the row begins in the grid.</param>
    public void ReadMarked(IReceiverRows receivers, int row, ReceiverGrid.Placed grid, int start)
    {
        EnsureWidth(receivers.Width);
        Count = grid.FindMarked(start, Columns.AsSpan(0, Width));
        if (Count > 0)
        {
            receivers.ReadAgain(row, Columns.AsSpan(0, Count), U.AsSpan(0, Count), V.AsSpan(0, Count), W.AsSpan(0, Count));
        }

        Pad();
    }

    /// <summary>Sum of the points, m, body-fixed; to be called before <see cref="ToLight"/>.</summary>
    public Vector3D Sum()
    {
        Vector3D sum = default;
        for (int i = 0; i < Count; i++)
        {
            sum += new Vector3D(U[i], V[i], W[i]);
        }

        return sum;
    }

    /// <summary>Converts the points from MOON_ME to light space.</summary>
    public void ToLight(LightFrame frame)
    {
        int padded = Padded(Count);
        frame.FromBodyFixed(U.AsSpan(0, padded), V.AsSpan(0, padded), W.AsSpan(0, padded));
    }

    /// <summary>Bounds of the points in light space, m; to be called after <see cref="ToLight"/>.</summary>
    public LightBox Box()
    {
        LightBox box = LightBox.Empty;
        for (int i = 0; i < Count; i++)
        {
            box = LightBox.Union(box, new LightBox(U[i], U[i], V[i], V[i]));
        }

        return box;
    }

    private void EnsureWidth(int width)
    {
        Width = width;
        if (Columns.Length < Padded(width))
        {
            (U, V, W) = (new double[Padded(width)], new double[Padded(width)], new double[Padded(width)]);
            Columns = new int[Padded(width)];
        }
    }

    private void Pad()
    {
        int padding = Padded(Count) - Count;
        U.AsSpan(Count, padding).Clear();
        V.AsSpan(Count, padding).Clear();
        W.AsSpan(Count, padding).Clear();
    }
}
