using Msisf.Core.Camera;
using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// Chooses the windows of a frame: of each level one around the ground that needs cells of that level or finer ones. Immutable.
/// </summary>
/// <param name="models">The models, the coarsest first.</param>
/// <param name="finestLevel">Cells are 2^this m wide at least.</param>
internal sealed class WindowPlan(IGroundDetail detail, IReadOnlyList<ITerrainGrid> models, int finestLevel)
{
    /// <summary>Samples of the border of the coarsest window in which it goes over into the models; less than the margin.</summary>
    public const int WidestBorder = 24;

    /// <summary>px: the width of cells that is asked for, as of levels of detail by default; a window's are up to twice as wide.</summary>
    private const double CellPixels = 0.7;

    /// <summary>Rays along each side of the image that look for the ground.</summary>
    private const int RaysPerAxis = 9;

    /// <summary>How often a ray's place on the ground is made better.</summary>
    private const int GroundSteps = 4;

    /// <summary>Cells along a side of a window at most, before it is extended to whole blocks.</summary>
    private const int MostCells = 768;

    /// <summary>Cells along a side of a map that a window is made to hold at most.</summary>
    private const double MostHeld = 2048.0;

    /// <summary>
    /// Cells of the narrowest window that is seen, along a side, from the nearest ground to the far end of a map that is held: the margins
    /// of the windows between come to these, and the window stays below the size of one that holds a map.
    /// </summary>
    private const double MostAway = MostHeld - (4 * (Margin + Snap));

    /// <summary>Cells of a window around a map that it holds: where finer facets join wider ones the map has ended.</summary>
    private const int HeldMargin = 4;

    /// <summary>
    /// Cells of a window around what needs it: ground beside the image throws shadows into it, and the border is blended.
    /// </summary>
    private const int Margin = 32;

    /// <summary>Sides of windows lie on multiples of so many cells, so that cameras near each other see the same windows.</summary>
    private const int Snap = CellBlock.Size;

    /// <summary>Radii of the Moon: windows stay within this of the middle of their map.</summary>
    private const double Extent = 0.98 * PolarStereographic.MaxExtent;

    private readonly FacetMesh[] _maps = [.. models.Skip(1).Select(model => new FacetMesh(model))];

    /// <summary>Level of the widest cells: half as wide as those of the coarsest model, or less.</summary>
    private readonly int _widestLevel = WidestIn(models[0]);

    /// <summary>The windows, the coarsest first; each holds the next one. None if the models' own cells are fine enough.</summary>
    /// <param name="subsamplesPerAxis">Samples along a pixel's edge.</param>
    public IReadOnlyList<WindowPlace> Of(ICamera camera, int subsamplesPerAxis)
    {
        if (camera.Bands.All(band => LevelBelow(band.Camera, subsamplesPerAxis) > _widestLevel))
        {
            return [];
        }

        (Vector3D Direction, double Distance, int Level)[] seen = [.. Seen(camera, subsamplesPerAxis)];
        if (seen.Length == 0 || seen.Min(ground => ground.Level) > _widestLevel)
        {
            return [];
        }

        Vector3D nearest = seen.MinBy(ground => ground.Distance).Direction;
        LatticeFace face = LatticeFace.Of(nearest);
        List<WindowPlace> places = [];
        int finest = seen.Min(ground => ground.Level);
        List<FacetMesh> toHold = MapsToHold(face, nearest, finest);

        // Around a map that is seen from afar, or lies beside the image, there is ground too, beyond a window as narrow as the map needs.
        for (int level = toHold.Select(mesh => WidestIn(mesh.Grid)).Append(finest).Min(); level <= _widestLevel; level++)
        {
            PolarStereographic map = face.Map(level);
            (double, double)[] held =
                [.. toHold.Where(mesh => WidestIn(mesh.Grid) == level).SelectMany(CornersOf).Select(map.PixelOf)];
            (double, double)[] wanted =
                [.. seen.Where(ground => ground.Level <= level).Select(ground => map.PixelOf(ground.Direction))];
            CellRange? finer = places.Count == 0 ? null : places[^1].Cells;
            WindowPlace place = Around(
                face, level, wanted, held, level < finest ? null : map.PixelOf(nearest), finer);
            bool isAtMapsEnd = places.Count > 0 && !HasMarginAround(place.Cells, places[^1].Cells);
            if (isAtMapsEnd || _maps.Any(mesh => level > WidestIn(mesh.Grid) && Meets(mesh, place) && !IsHeld(mesh, places)))
            {
                break; // where a finer model has data, it wins
            }

            places.Add(place);
        }

        places.Reverse();
        return places;
    }

    /// <summary>The level that a pixel would need on the highest ground, right below the camera.</summary>
    private int LevelBelow(FrameCamera camera, int subsamplesPerAxis) => LevelOf(
        (camera.PositionBodyFixed.Length - detail.RadiusLimits.Max) * (camera.Footprint.Tangent / subsamplesPerAxis));

    private static int WidestIn(ITerrainGrid model) => (int)Math.Floor(Math.Log2(0.5 * model.Projection.Resolution.MetresPerPixel));

    private static bool HasMarginAround(CellRange outer, CellRange inner) =>
        (inner.FirstLine / 2) - outer.FirstLine >= Margin && outer.EndLine - (inner.EndLine / 2) >= Margin
        && (inner.FirstSample / 2) - outer.FirstSample >= Margin && outer.EndSample - (inner.EndSample / 2) >= Margin;

    private static bool Meets(FacetMesh mesh, WindowPlace place)
    {
        CellRange cells = place.Cells;
        SphericalCap cap = new PlaneNodes(place.Face.Map(place.Level)).CapOf(cells);
        CellRange all = mesh.Cells;
        return Array.Exists(CapWindow.Of(mesh, cap, 0.0), range =>
            range.FirstLine < all.EndLine && range.EndLine > all.FirstLine
            && range.FirstSample < all.EndSample && range.EndSample > all.FirstSample);
    }

    /// <summary>
    /// The maps that are small and near enough to be held: the widest window that may lie over a map holds it, and wider ones around that
    /// leave the map as it is.
    /// </summary>
    /// <param name="nearest">The nearest ground that is seen.</param>
    /// <param name="finest">Level of the narrowest cells that are seen.</param>
    private List<FacetMesh> MapsToHold(LatticeFace face, Vector3D nearest, int finest)
    {
        List<FacetMesh> held = [];
        foreach (FacetMesh mesh in _maps)
        {
            int level = WidestIn(mesh.Grid);
            Vector3D[] corners = [.. held.Where(other => WidestIn(other.Grid) == level).Append(mesh).SelectMany(CornersOf)];
            double size = level < finest ? SizeOf(corners, face.Map(level)) : SizeOf([.. corners, nearest], face.Map(level));
            if (size <= MostHeld && (level >= finest || SizeOf([.. corners, nearest], face.Map(finest)) <= MostAway))
            {
                held.Add(mesh);
            }
        }

        return held;
    }

    /// <summary>Cells along the longer side of a rectangle around places.</summary>
    private static double SizeOf(Vector3D[] places, PolarStereographic map)
    {
        (double Line, double Sample)[] at = [.. places.Select(map.PixelOf)];
        return Math.Max(
            at.Max(place => place.Line) - at.Min(place => place.Line), at.Max(place => place.Sample) - at.Min(place => place.Sample));
    }

    private static IEnumerable<Vector3D> CornersOf(FacetMesh mesh)
    {
        CellRange all = mesh.Cells;
        foreach (double line in (double[])[all.FirstLine, 0.5 * (all.FirstLine + all.EndLine), all.EndLine])
        {
            foreach (double sample in (double[])[all.FirstSample, 0.5 * (all.FirstSample + all.EndSample), all.EndSample])
            {
                yield return mesh.Grid.Projection.DirectionOf(line, sample);
            }
        }
    }

    /// <summary>Whether the last window holds a map with a margin.</summary>
    private static bool IsHeld(FacetMesh mesh, List<WindowPlace> places)
    {
        if (places.Count == 0)
        {
            return false;
        }

        WindowPlace last = places[^1];
        PolarStereographic map = last.Face.Map(last.Level);
        return CornersOf(mesh).Select(map.PixelOf).All(at =>
            at.Line >= last.Cells.FirstLine + HeldMargin && at.Line <= last.Cells.EndLine - HeldMargin
            && at.Sample >= last.Cells.FirstSample + HeldMargin && at.Sample <= last.Cells.EndSample - HeldMargin);
    }

    private static WindowPlace Around(
        LatticeFace face, int level, (double Line, double Sample)[] wanted, (double Line, double Sample)[] held,
        (double Line, double Sample)? nearest, CellRange? finer)
    {
        (int Low, int High)? holeLines = finer is { } a ? (a.FirstLine / 2, a.EndLine / 2) : null;
        (int Low, int High)? holeSamples = finer is { } b ? (b.FirstSample / 2, b.EndSample / 2) : null;
        int most = (int)(Extent * MoonConstants.ReferenceRadius / Math.ScaleB(1.0, level)) / Snap * Snap;
        (int firstLine, int endLine) = Side(
            [.. wanted.Select(at => at.Line)], [.. held.Select(at => at.Line)], nearest?.Line, holeLines, most);
        (int firstSample, int endSample) = Side(
            [.. wanted.Select(at => at.Sample)], [.. held.Select(at => at.Sample)], nearest?.Sample, holeSamples, most);
        return new WindowPlace(face, level, new CellRange(firstLine, endLine, firstSample, endSample));
    }

    /// <summary>One side of a window.</summary>
    /// <param name="wanted">Where it is wanted.</param>
    /// <param name="held">Corners of the models' maps that it has to hold, as wide as they are.</param>
    /// <param name="nearest">The place that must be in it; null if it is there only to hold maps.</param>
    /// <param name="hole">The finer window in it.</param>
    /// <param name="most">The farthest line from the middle of the map.</param>
    private static (int First, int End) Side(
        double[] wanted, double[] held, double? nearest, (int Low, int High)? hole, int most)
    {
        double mostCells = held.Length > 0 ? MostHeld + (2 * Margin) : MostCells;
        (double low, double high) = EndsOf([.. wanted, .. held]);
        (double leastLow, double leastHigh) = EndsOf(held);
        if (high - low > mostCells && (held.Length > 0 || leastHigh - leastLow > mostCells || nearest is null))
        {
            (low, high) = (leastLow, leastHigh); // wider windows around this one have the rest
        }
        else if (high - low > mostCells && nearest is { } inAnyCase)
        {
            double part = Math.Clamp((inAnyCase - low) / (high - low), 0.0, 1.0);
            low = Math.Min(inAnyCase - (part * MostCells), (hole?.Low ?? inAnyCase) - Margin);
            low = Math.Max(low, (hole?.High ?? inAnyCase) + Margin - MostCells);
            high = low + MostCells;
        }

        return (
            Math.Max(-most, (int)Math.Floor(low / Snap) * Snap),
            Math.Min(most, (int)Math.Ceiling(high / Snap) * Snap));

        (double Low, double High) EndsOf(double[] places)
        {
            IEnumerable<double> all = (hole, nearest) switch
            {
                ({ } inner, _) => [.. places, inner.Low, inner.High],
                (null, { } place) => [.. places, place],
                _ => places,
            };
            return (all.Min() - Margin, all.Max() + Margin);
        }
    }

    /// <summary>Directions of the ground that rays through the image meet, its distance, and the level that a pixel needs there.</summary>
    private IEnumerable<(Vector3D Direction, double Distance, int Level)> Seen(ICamera camera, int subsamplesPerAxis)
    {
        for (int i = 0; i < RaysPerAxis * RaysPerAxis; i++)
        {
            double x = 0.5 + (i % RaysPerAxis * (double)camera.Width / (RaysPerAxis - 1));
            double y = 0.5 + (i / RaysPerAxis * (double)camera.Height / (RaysPerAxis - 1));
            Ray ray = camera.RayThrough(x, y);
            FrameCamera seenBy = camera.BandAt(y).Camera;
            if (GroundOn(ray.Origin, ray.Direction.Normalized(), seenBy.PixelTangent / subsamplesPerAxis) is { } place)
            {
                double width = seenBy.Footprint.MinWidth((place, 0.0)) / subsamplesPerAxis;
                yield return (
                    place.Normalized(), (place - ray.Origin).Length, Math.Max(finestLevel, LevelOf(width)));
            }
        }
    }

    /// <summary>
    /// About where a ray meets the ground, found on spheres through the ground below the last guess; where it passes above, its place
    /// nearest to the Moon, and null if that is behind the camera.
    /// </summary>
    private Vector3D? GroundOn(Vector3D origin, Vector3D along, double tangent)
    {
        double height = origin.Length;
        double radius = detail.RadiusAt(origin.Normalized(), Math.ScaleB(1.0, finestLevel));
        double t = 0.0;
        for (int step = 0; step < GroundSteps; step++)
        {
            double up = Vector3D.Dot(origin, along);
            double square = (up * up) - ((height - radius) * (height + radius));
            double next = -up - (square > 0.0 && radius < height ? Math.Sqrt(square) : 0.0);
            if (!(next > 0.0))
            {
                return t > 0.0 ? origin + (0.5 * t * along) : null; // a hill before the camera, higher than it
            }

            t = next;
            double cell = Math.ScaleB(1.0, Math.Clamp(LevelOf(t * tangent), finestLevel, _widestLevel));
            radius = detail.RadiusAt((origin + (t * along)).Normalized(), cell);
        }

        return origin + (t * along);
    }

    private static int LevelOf(double pixel) => (int)Math.Ceiling(Math.Log2(Math.Max(CellPixels * pixel, double.Epsilon)));
}

/// <summary>Where a generated window lies: a rectangle of cells of a lattice.</summary>
/// <param name="Face">The map.</param>
/// <param name="Level">Cells are 2^Level m wide.</param>
/// <param name="Cells">The cells, counted in the lattice.</param>
internal readonly record struct WindowPlace(LatticeFace Face, int Level, CellRange Cells);
