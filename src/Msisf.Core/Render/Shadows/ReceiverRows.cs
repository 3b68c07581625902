using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>The receivers of a frame, row by row of the image; the arrays are kept from frame to frame.</summary>
internal sealed class ReceiverRows
{
    private static readonly int Lanes = Vector512<double>.Count;

    private int[] _counts = [];
    private int _stride;

    /// <summary>Coordinate in light space, m (in MOON_ME before <see cref="ToLight"/>); a row begins at <see cref="Start"/>.</summary>
    public double[] U { get; private set; } = [];

    /// <inheritdoc cref="U"/>
    public double[] V { get; private set; } = [];

    /// <inheritdoc cref="U"/>
    public double[] W { get; private set; } = [];

    /// <summary>Column of the image of each receiver.</summary>
    public int[] Columns { get; private set; } = [];

    /// <summary>Makes room for an image.</summary>
    public void Prepare(int rows, int width)
    {
        _stride = (width + Lanes - 1) / Lanes * Lanes;
        int needed = rows * _stride;
        if (U.Length < needed)
        {
            U = new double[needed];
            V = new double[needed];
            W = new double[needed];
            Columns = new int[needed];
        }

        if (_counts.Length < rows)
        {
            _counts = new int[rows];
        }
    }

    /// <summary>Index of a row's first receiver.</summary>
    public int Start(int row) => row * _stride;

    /// <summary>Number of receivers in a row.</summary>
    public int Count(int row) => _counts[row];

    /// <summary>Reads the receivers of a row, in MOON_ME.</summary>
    public void Read(IReceiverRows receivers, int row)
    {
        int start = Start(row);
        int width = receivers.Width;
        int count = receivers.Read(
            row, U.AsSpan(start, width), V.AsSpan(start, width), W.AsSpan(start, width), Columns.AsSpan(start, width));
        int padding = PaddedCount(count) - count;
        U.AsSpan(start + count, padding).Clear();
        V.AsSpan(start + count, padding).Clear();
        W.AsSpan(start + count, padding).Clear();
        _counts[row] = count;
    }

    /// <summary>Sum of a row's points, m, MOON_ME; to be called before <see cref="ToLight"/>.</summary>
    public Vector3D Sum(int row)
    {
        Vector3D sum = default;
        for (int i = Start(row); i < Start(row) + _counts[row]; i++)
        {
            sum += new Vector3D(U[i], V[i], W[i]);
        }

        return sum;
    }

    /// <summary>Converts a row's points from MOON_ME to light space.</summary>
    public void ToLight(LightFrame frame, int row)
    {
        int start = Start(row);
        int padded = PaddedCount(_counts[row]);
        frame.FromMoonMe(U.AsSpan(start, padded), V.AsSpan(start, padded), W.AsSpan(start, padded));
    }

    /// <summary>Bounds of a row's points in light space, m; to be called after <see cref="ToLight"/>.</summary>
    public LightBox BoxOf(int row)
    {
        LightBox box = LightBox.Empty;
        for (int i = Start(row); i < Start(row) + _counts[row]; i++)
        {
            box = LightBox.Union(box, new LightBox(U[i], U[i], V[i], V[i]));
        }

        return box;
    }

    private static int PaddedCount(int count) => (count + Lanes - 1) / Lanes * Lanes;
}
