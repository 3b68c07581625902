using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>The receivers of a frame, row by row; its arrays serve all frames of a size.</summary>
internal sealed class ReceiverStore
{
    private const int Lanes = 8;

    private double[] _u = [];
    private double[] _v = [];
    private double[] _w = [];
    private int[] _columns = [];
    private int[] _counts = [];
    private int _stride;

    /// <summary>Makes room for a picture.</summary>
    public void Prepare(int rows, int width)
    {
        _stride = (width + Lanes - 1) / Lanes * Lanes;
        int needed = rows * _stride;
        if (_u.Length < needed)
        {
            _u = new double[needed];
            _v = new double[needed];
            _w = new double[needed];
            _columns = new int[needed];
        }

        if (_counts.Length < rows)
        {
            _counts = new int[rows];
        }
    }

    /// <summary>Reads a row; its points are in MOON_ME until <see cref="ToLight"/>.</summary>
    public void Read(IReceiverRows receivers, int row)
    {
        int start = row * _stride;
        int width = receivers.Width;
        _counts[row] = receivers.Read(
            row, _u.AsSpan(start, width), _v.AsSpan(start, width), _w.AsSpan(start, width), _columns.AsSpan(start, width));
    }

    /// <summary>Turns a row's points from MOON_ME to light space.</summary>
    public void ToLight(LightFrame frame, int row)
    {
        int start = row * _stride;
        int count = _counts[row];
        int padded = (count + Lanes - 1) / Lanes * Lanes;
        _u.AsSpan(start + count, padded - count).Clear();
        _v.AsSpan(start + count, padded - count).Clear();
        _w.AsSpan(start + count, padded - count).Clear();
        frame.FromMoonMe(_u.AsSpan(start, padded), _v.AsSpan(start, padded), _w.AsSpan(start, padded));
    }

    /// <summary>Sum of a row's points, m.</summary>
    public Vector3D Sum(int row)
    {
        ReceiverRow points = this[row];
        Vector3D sum = default;
        for (int i = 0; i < points.Count; i++)
        {
            sum += new Vector3D(points.U[i], points.V[i], points.W[i]);
        }

        return sum;
    }

    /// <summary>The receivers of a row.</summary>
    public ReceiverRow this[int row] => new(
        _u.AsSpan(row * _stride, _counts[row]),
        _v.AsSpan(row * _stride, _counts[row]),
        _w.AsSpan(row * _stride, _counts[row]),
        _columns.AsSpan(row * _stride, _counts[row]));

    /// <summary>Keeps the first receivers of a row only.</summary>
    public void Truncate(int row, int count) => _counts[row] = count;
}
