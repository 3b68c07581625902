using Msisf.Core.Terrain;

namespace Msisf.Core.Surface;

/// <summary>
/// Bounds of rectangles of cells in polar stereographic projection, independent of their heights and without trigonometry. Immutable.
/// </summary>
/// <remarks>
/// In units of 2 R the points p and c of the plane are seen at an angle t with sin(t / 2)^2 = |p - c|^2 / ((1 + |p|^2) (1 + |c|^2)).
/// Circles around a direction are circles of the plane, so of a rectangle a corner is farthest from its middle: of the four, which have one
/// distance in the plane, the one nearest to the pole. The projection of the direction of p on the tangent of the u axis at c is
/// 2 (du + (du^2 + dv^2) cu / (1 + |c|^2)) / (1 + |p|^2), with (du, dv) = p - c.
/// </remarks>
internal sealed class PlaneNodes(PolarStereographic projection)
{
    /// <summary>The cap that holds the directions of all facets of a rectangle of cells.</summary>
    public SphericalCap CapOf(CellRange cells) => new Rectangle(projection, cells).Cap();

    /// <summary>The box that holds all facets of a rectangle of cells whose vertex radii lie within bounds (m).</summary>
    public NodeBox BoxOf(CellRange cells, double minRadius, double maxRadius)
    {
        Rectangle rectangle = new(projection, cells);
        SphericalCap cap = rectangle.Cap();
        double highest = maxRadius + Tolerances.VertexLattice;
        double lowest = (minRadius - Tolerances.VertexLattice) * cap.CosRadius;
        OrientedBox box = new(
            (0.5 * (highest + lowest)) * cap.Centre,
            (0.5 * (highest - lowest)) * cap.Centre,
            (highest * rectangle.HalfAlongU) * rectangle.AlongU,
            (highest * rectangle.HalfAlongV) * rectangle.AlongV);
        return new NodeBox(cap.Centre, new SineCosine(cap.SinRadius, cap.CosRadius), box);
    }

    /// <summary>
    /// Upper bound, 1/rad, of the inverse of the angle between neighbouring vertices of a line's part: to the right, and upwards.
    /// </summary>
    /// <param name="line">The line; the vertices above it count.</param>
    /// <param name="firstSample">The part's first vertex.</param>
    /// <param name="lastSample">The part's last vertex.</param>
    public double PerRadian(int line, int firstSample, int lastSample)
    {
        double a = Math.Max(Math.Abs(projection.A(firstSample)), Math.Abs(projection.A(lastSample)));
        double b = Math.Max(Math.Abs(projection.B(line)), Math.Abs(projection.B(line - 1)));
        return (1.0 + (0.25 * ((a * a) + (b * b)))) * MoonConstants.ReferenceRadius / projection.MetresPerPixel;
    }

    /// <summary>A rectangle of the plane, in 2 R.</summary>
    private readonly ref struct Rectangle
    {
        private readonly double _u;
        private readonly double _v;
        private readonly double _halfU;
        private readonly double _halfV;
        private readonly double _scale;
        private readonly double _sign;
        private readonly PolarStereographic _projection;

        public Rectangle(PolarStereographic projection, CellRange cells)
        {
            double west = 0.5 * projection.A(cells.FirstSample);
            double east = 0.5 * projection.A(cells.EndSample);
            double first = 0.5 * projection.B(cells.FirstLine);
            double last = 0.5 * projection.B(cells.EndLine);
            _u = 0.5 * (west + east);
            _v = 0.5 * (first + last);
            _halfU = 0.5 * (east - west);
            _halfV = 0.5 * Math.Abs(last - first);
            _scale = 1.0 / (1.0 + (_u * _u) + (_v * _v));
            _sign = projection.PoleSign;
            _projection = projection;
        }

        /// <summary>Tangent of the u axis in the middle, length 1.</summary>
        public Vector3D AlongU => _projection.ToBodyFixed(
            new(-2.0 * _u * _v * _scale, 1.0 - (2.0 * _u * _u * _scale), -2.0 * _sign * _u * _scale));

        /// <summary>Tangent of the v axis in the middle, length 1.</summary>
        public Vector3D AlongV => _projection.ToBodyFixed(
            new(1.0 - (2.0 * _v * _v * _scale), -2.0 * _u * _v * _scale, -2.0 * _sign * _v * _scale));

        /// <summary>Half of the extent along <see cref="AlongU"/>, as a fraction of the radius.</summary>
        public double HalfAlongU => Tolerances.CapRadius + HalfAlong(_halfU, _u);

        /// <summary>Half of the extent along <see cref="AlongV"/>, as a fraction of the radius.</summary>
        public double HalfAlongV => Tolerances.CapRadius + HalfAlong(_halfV, _v);

        public SphericalCap Cap()
        {
            double nearU = Math.Abs(_u) - _halfU;
            double nearV = Math.Abs(_v) - _halfV;
            double squaredHalfSine = ((_halfU * _halfU) + (_halfV * _halfV)) * _scale / (1.0 + (nearU * nearU) + (nearV * nearV));
            double cosine = 1.0 - (2.0 * squaredHalfSine);
            double sine = 2.0 * Math.Sqrt(squaredHalfSine * (1.0 - squaredHalfSine));
            Vector3D centre = _projection.ToBodyFixed(
                new Vector3D(2.0 * _v * _scale, 2.0 * _u * _scale, _sign * ((2.0 * _scale) - 1.0)));

            // Wider by the angle CapRadius, whose square is below the rounding.
            return new SphericalCap(centre, cosine - (Tolerances.CapRadius * sine), sine + (Tolerances.CapRadius * cosine));
        }

        private double HalfAlong(double half, double middle)
        {
            double nearU = Math.Max(0.0, Math.Abs(_u) - _halfU);
            double nearV = Math.Max(0.0, Math.Abs(_v) - _halfV);
            double bulge = ((_halfU * _halfU) + (_halfV * _halfV)) * Math.Abs(middle) * _scale;
            return 2.0 * (half + bulge) / (1.0 + (nearU * nearU) + (nearV * nearV));
        }
    }
}
