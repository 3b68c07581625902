namespace Msisf.Core.Render.Shadows;

/// <summary>
/// The least depth of the facets that face away from the Sun in each bin of a grid across its rays: only what lies deeper may be in shadow.
/// </summary>
internal sealed class CasterDepths
{
    /// <summary>Times that a box is made smaller: the nearer the facets are found to be, the nearer to it they must lie.</summary>
    private const int Looks = 3;

    private readonly DepthGrid _before = new(); // minus the depths: the grid finds maxima

    /// <summary>Begins a frame, without facets.</summary>
    /// <param name="box">Bounds of what may be in shadow.</param>
    /// <param name="size">Number of bins along each edge of the grid.</param>
    public void Lay(LightBox box, int size)
    {
        _before.Lay(box, size, size);
        _before.Bins.AsSpan(0, size * size).Fill(float.NegativeInfinity);
    }

    /// <summary>Adds a facet that faces away from the Sun. Several threads may call it.</summary>
    public void Add(in LightFacet facet)
    {
        LightBox box = facet.Box;
        GridRange bins = _before.BinsOf(in box);
        double minDepth = facet.MinDepth;
        (double ub, double vb, double wb) = (facet.Ub - facet.Ua, facet.Vb - facet.Va, facet.Wb - facet.Wa);
        (double uc, double vc, double wc) = (facet.Uc - facet.Ua, facet.Vc - facet.Va, facet.Wc - facet.Wa);
        double area = (ub * vc) - (uc * vb);
        double perU = ((wb * vc) - (wc * vb)) / area;
        double perV = ((wc * ub) - (wb * uc)) / area;

        // The corners are rounded, and with them the plane: the more, the nearer the facet is to a line.
        double sides = Math.Max((ub * ub) + (vb * vb), (uc * uc) + (vc * vc));
        double rounding = Tolerances.LightPoint * (1.0 + (8.0 * (Math.Abs(perU) + Math.Abs(perV)) * sides / Math.Abs(area)));
        (LightAxis u, LightAxis v) = (_before.AxisU, _before.AxisV);
        for (int row = bins.FirstRow; row <= bins.LastRow; row++)
        {
            (double minV, double maxV) = Within(v, row, box.MinV, box.MaxV);
            (double minU, double maxU) = facet.Between(minV, maxV);
            double ofRow = facet.Wa - rounding + (perV * ((perV > 0.0 ? minV : maxV) - facet.Va));
            int last = Math.Min(bins.LastColumn, u.BinOf(maxU + Tolerances.LightPoint));
            for (int column = Math.Max(bins.FirstColumn, u.BinOf(minU - Tolerances.LightPoint)); column <= last; column++)
            {
                (double first, double end) = Within(u, column, box.MinU, box.MaxU);
                double nearest = ofRow + (perU * ((perU > 0.0 ? first : end) - facet.Ua));

                // An edge-on facet has no plane over the bins: then the comparison with NaN leaves its nearest corner.
                SetLeast((row * _before.Size) + column, nearest > minDepth ? nearest : minDepth);
            }
        }
    }

    /// <summary>Ends the adding of facets.</summary>
    public void Finish() => _before.Finish();

    /// <summary>Whether a facet that was added may hide something from the Sun's centre.</summary>
    /// <param name="box">Its bounds, m.</param>
    /// <param name="maxDepth">Its maximum depth, m.</param>
    public bool MayHide(in LightBox box, double maxDepth) => !(-maxDepth > _before.Max(_before.BinsOf(in box)));

    /// <summary>Whether a facet that was added may hide something from a part of the Sun's disc.</summary>
    /// <param name="box">Its bounds, m.</param>
    /// <param name="maxDepth">Its maximum depth, m.</param>
    /// <param name="slope">Radius of the disc over its distance: so far beside the box a facet may lie for each metre before it.</param>
    public bool MayHide(in LightBox box, double maxDepth, double slope)
    {
        double nearest = -_before.Max();
        for (int look = 0; look < Looks && nearest < maxDepth; look++)
        {
            LightBox reach = box.Widened((slope * (maxDepth - nearest)) + SureLight.Margin);
            nearest = -_before.Max(_before.BinsOf(in reach));
        }

        return !(nearest > maxDepth);
    }

    /// <summary>What a facet with some limits has of a bin along one axis; the outermost bins extend to infinity.</summary>
    private (double Min, double Max) Within(LightAxis axis, int bin, double min, double max) => (
        bin == 0 ? min : Math.Max(min, axis.StartOf(bin) - Tolerances.LightPoint),
        bin == _before.Size - 1 ? max : Math.Min(max, axis.StartOf(bin + 1) + Tolerances.LightPoint));

    private void SetLeast(int bin, double depth)
    {
        ref float before = ref _before.Bins[bin];
        float wanted = MathF.BitIncrement((float)-depth);
        for (float seen = before; wanted > seen;)
        {
            float now = Interlocked.CompareExchange(ref before, wanted, seen);
            if (now == seen)
            {
                return;
            }

            seen = now;
        }
    }
}
