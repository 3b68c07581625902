using Msisf.Core.Surface;

namespace Msisf.Core.Certainty;

/// <summary>
/// Finds facets that beams can meet while all corners rise and fall. Remembers facets, so each thread needs its own object.
/// </summary>
/// <param name="surface">The surface as it is drawn; it is closed.</param>
/// <param name="reach">m: by which each corner may be higher or lower.</param>
/// <param name="toSun">Direction to the Sun from the body's centre, length 1.</param>
/// <param name="sunAngle">rad: by which the direction to a point of the Sun may differ from that on any of the ground.</param>
internal sealed class BandSearch(SurfaceModel surface, double reach, Vector3D toSun, double sunAngle)
{
    /// <summary>Nodes whose facets are remembered: each takes some 40 KB.</summary>
    private const int Remembered = 1024;

    private readonly Dictionary<SurfaceNode, NodeFacets> _facets = [];
    private readonly double _top = surface.RadiusLimits.Max + reach + (2.0 * Tolerances.VertexLattice);

    private double Reach => reach;

    /// <summary>rad: the radius that a ball has, seen from a point.</summary>
    /// <param name="distance">To its middle, as <paramref name="radius"/> is; a ball that is nearer than its radius is everywhere.</param>
    public static double AngleOf(double radius, double distance) =>
        radius < distance ? Math.Atan2(radius, Math.Sqrt((distance - radius) * (distance + radius))) : Math.PI;

    /// <summary>Finds the facets that the rays of a beam can meet.</summary>
    /// <param name="onlyCasters">Only facets that may face away from the Sun: what rays to the Sun meet first, from outside.</param>
    /// <param name="meetings">Receives them.</param>
    public void Find(in Beam beam, bool onlyCasters, List<Meeting> meetings)
    {
        // Beyond its nearest approach to the centre and the same way again, it is outside.
        double end = Math.Abs(Vector3D.Dot(beam.Origin, beam.Direction)) + _top;
        for (int part = 0; part < surface.Patches.Length; part++)
        {
            Patch patch = surface.Patches[part];
            if (!patch.IsLeftOut)
            {
                BeamTester tester = new(this, patch, part, beam, new Interval(0.0, end), onlyCasters, meetings);
                NodeWalk.All(patch.Layout, ref tester);
            }
        }
    }

    /// <summary>Whether a ball is below the surface in all its forms.</summary>
    public bool IsInside(Vector3D centre, double radius)
    {
        for (int part = 0; part < surface.Patches.Length; part++)
        {
            Patch patch = surface.Patches[part];
            if (!patch.IsLeftOut)
            {
                BallTester tester = new(this, patch, part, centre, radius);
                if (!NodeWalk.All(patch.Layout, ref tester))
                {
                    return false;
                }
            }
        }

        return true;
    }

    /// <summary>Bounds of a node; of a large one only if they are known, for it would be read.</summary>
    private NodeBounds BoundsOf(Patch patch, NodePlace node) =>
        node.Level <= SquareLayout.CellBlockLevel ? patch.BoundsOf(node)
        : patch.TryGetKnown(node, out NodeBounds known) ? known
        : NodeBounds.Within(surface.RadiusLimits);

    private NodeFacets FacetsOf(Patch patch, int part, NodePlace node)
    {
        SurfaceNode key = new(part, node);
        if (_facets.TryGetValue(key, out NodeFacets known))
        {
            return known;
        }

        if (_facets.Count >= Remembered)
        {
            _facets.Clear();
        }

        FacetBand[] all = [.. patch.FacetsOf(node)
            .Select(facet => FacetBand.Of(facet with { Part = part }, patch.CornersOf(facet), reach)).OfType<FacetBand>()];
        return _facets[key] = new NodeFacets(all, [.. all.Where(facet => facet.MayFaceAway(toSun, sunAngle))]);
    }

    private readonly record struct NodeFacets(FacetBand[] All, FacetBand[] Casters);

    private readonly struct BeamTester(
        BandSearch search, Patch patch, int part, Beam beam, Interval within, bool onlyCasters, List<Meeting> meetings) : INodeTester
    {
        public Visit Test(NodePlace node)
        {
            NodeBounds bounds = search.BoundsOf(patch, node);
            OrientedBox box = patch.BoxOf(node, bounds.Min, bounds.Max).Box;
            Interval met = Slab(Slab(Slab(within, in box, box.HalfX), in box, box.HalfY), in box, box.HalfZ);
            if (!(met.Low <= met.High))
            {
                return Visit.Skip;
            }

            if (node.Level > 0)
            {
                return Visit.Descend;
            }

            NodeFacets facets = search.FacetsOf(patch, part, node);
            foreach (FacetBand facet in onlyCasters ? facets.Casters : facets.All)
            {
                Interval there = facet.Met(in beam, within);
                if (there.Low <= there.High)
                {
                    Interval below = facet.Below(in beam, within);
                    meetings.Add(new Meeting(facet, there, below.Low <= below.High ? below.Low : double.PositiveInfinity));
                }
            }

            return Visit.Skip;
        }

        private Interval Slab(Interval distances, in OrientedBox box, Vector3D half)
        {
            double length = Math.Sqrt(half.LengthSquared);
            if (length == 0.0)
            {
                return distances;
            }

            Vector3D axis = half / length;
            double middle = Vector3D.Dot(axis, box.Centre);
            double far = length + search.Reach;
            distances = beam.Touching(distances, axis, middle - far);
            return beam.Touching(distances, -axis, -middle - far);
        }
    }

    private readonly struct BallTester(BandSearch search, Patch patch, int part, Vector3D centre, double radius) : INodeTester
    {
        public Visit Test(NodePlace node)
        {
            double distance = Math.Sqrt(centre.LengthSquared);
            NodeBounds bounds = search.BoundsOf(patch, node);
            TerrainNode whole = patch.NodeOf(node, bounds);

            // The ball is in the cap's directions unless both middles are farther apart than both radii together.
            double between = Vector3D.AngleBetween(whole.Cap.Centre, centre);
            double reached = Math.Atan2(whole.Cap.SinRadius, whole.Cap.CosRadius) + AngleOf(radius, distance);
            if (between > reached + Tolerances.CapRadius || distance + radius < whole.MinRadius - search.Reach)
            {
                return Visit.Skip;
            }

            if (node.Level > 0)
            {
                return Visit.Descend;
            }

            foreach (FacetBand facet in search.FacetsOf(patch, part, node).All)
            {
                if (!facet.IsAbove(centre, radius))
                {
                    return Visit.Stop;
                }
            }

            return Visit.Skip;
        }
    }
}

/// <summary>A facet that rays of a beam can meet.</summary>
/// <param name="Facet">The facet.</param>
/// <param name="Where">m along the beam: where they can.</param>
/// <param name="BelowFrom">m: from where on they are below it; infinity if they never are.</param>
internal readonly record struct Meeting(FacetBand Facet, Interval Where, double BelowFrom);
