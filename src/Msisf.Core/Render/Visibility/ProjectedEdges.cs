using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Visibility;

/// <summary>Edges between projected corners: (a - p) x (b - p), as <see cref="CellSieve"/> has it.</summary>
internal struct ProjectedEdges : IFacetEdges
{
    /// <summary>px: more than rounding moves an edge's crossing with a row.</summary>
    private const double Slack = 1e-6;

    private readonly (double X, double Y) _a;
    private readonly (double X, double Y) _b;
    private readonly (double X, double Y) _c;
    private readonly double _slopeAb;
    private readonly double _slopeBc;
    private readonly double _slopeCa;
    private readonly Vector512<double> _ax;
    private readonly Vector512<double> _bx;
    private readonly Vector512<double> _cx;
    private Vector512<double> _downA;
    private Vector512<double> _downB;
    private Vector512<double> _downC;

    public ProjectedEdges((double X, double Y) a, (double X, double Y) b, (double X, double Y) c)
    {
        (_a, _b, _c) = (a, b, c);
        _slopeAb = (b.X - a.X) / (b.Y - a.Y);
        _slopeBc = (c.X - b.X) / (c.Y - b.Y);
        _slopeCa = (a.X - c.X) / (a.Y - c.Y);
        _ax = Vector512.Create(a.X);
        _bx = Vector512.Create(b.X);
        _cx = Vector512.Create(c.X);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (double First, double Last) MoveTo(double row)
    {
        double downA = _a.Y - row;
        double downB = _b.Y - row;
        double downC = _c.Y - row;
        _downA = Vector512.Create(downA);
        _downB = Vector512.Create(downB);
        _downC = Vector512.Create(downC);
        double first = double.PositiveInfinity;
        double last = double.NegativeInfinity;
        Widen(_a.X, downA, downB, _slopeAb, ref first, ref last);
        Widen(_b.X, downB, downC, _slopeBc, ref first, ref last);
        Widen(_c.X, downC, downA, _slopeCa, ref first, ref last);
        return (first - Slack, last + Slack);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector512<double> Outside(Vector512<double> columns)
    {
        Vector512<double> a = _ax - columns;
        Vector512<double> b = _bx - columns;
        Vector512<double> c = _cx - columns;
        return Vector512.MaxNative(
            (a * _downB) - (b * _downA),
            Vector512.MaxNative((b * _downC) - (c * _downB), (c * _downA) - (a * _downC)));
    }

    /// <summary>Adds an edge's crossing with the row. An edge along the row has none: its neighbours end where it does.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Widen(double x, double down, double otherDown, double slope, ref double first, ref double last)
    {
        double crossing = x - (down * slope);
        if (down * otherDown <= 0.0 && double.IsFinite(crossing))
        {
            first = Math.Min(first, crossing);
            last = Math.Max(last, crossing);
        }
    }
}
