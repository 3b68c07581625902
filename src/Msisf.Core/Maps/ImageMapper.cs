using Msisf.Core.Camera;
using Msisf.Core.Parallel;
using Msisf.Core.Render;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.Core.Maps;

/// <summary>
/// Finds the pixels in which an image shows the cells of a map. Each cell is represented by its centre: single rays find where it is
/// and whether other ground hides it from the camera.
/// </summary>
public sealed class ImageMapper(IGroundTruth truth, ITerrain terrain)
{
    /// <summary>Cells of a map at most.</summary>
    public const int MaxCells = 50_000_000;

    /// <summary>m above the highest ground, from where it is looked for.</summary>
    private const double Above = 1e3;

    /// <summary>Part of a map's width by which it grows while its border still shows something.</summary>
    private const int Growth = 16;

    /// <summary>Degrees: to so much the centre of a map is rounded.</summary>
    private const int CentreDigits = 4;

    private readonly TerrainTracer _tracer = new(terrain);

    /// <summary>The map of all that the image shows.</summary>
    /// <param name="cell">m: width of a cell.</param>
    /// <returns>Null if the image shows no ground.</returns>
    /// <exception cref="BadInputException">The map can't show that ground, or has too many cells, or none.</exception>
    public ImageMap? Find(MapKind kind, double cell, int threads, CancellationToken cancellation)
    {
        Vector3D mean = MeanDirection(threads, cancellation);
        if (mean == default)
        {
            return null;
        }

        (GroundProjection projection, CellBox box) = PlaceOf(kind, mean, cell, threads, cancellation);
        box = Grown(box, projection, cell, threads, cancellation);
        int[] pixels = new int[box.Lines * box.Samples];
        WorkerTeam.Run(
            threads,
            (int)box.Lines,
            (_, line) =>
            {
                for (int sample = 0; sample < box.Samples; sample++)
                {
                    pixels[(line * box.Samples) + sample] = PixelOf(projection, cell, box.Top + line, box.Left + sample);
                }
            },
            cancellation);
        return Cut(projection, cell, box, pixels);
    }

    /// <summary>The pixel that shows a cell; -1 for none.</summary>
    private int PixelOf(GroundProjection projection, double cell, long line, long sample)
    {
        double top = terrain.RadiusLimits.Max + Above;
        ICamera camera = truth.Camera;
        if (projection.ToDirection((sample + 0.5) * cell, -(line + 0.5) * cell) is not { } direction
            || !_tracer.TryTrace(new Ray(top * direction, -direction), out SurfaceHit ground)
            || !camera.TryProjectPoint(ground.PointBodyFixed, out RenderingPoint seen))
        {
            return -1;
        }

        bool isShown = seen.X >= 0.5 && seen.X < camera.Width + 0.5 && seen.Y >= 0.5 && seen.Y < camera.Height + 0.5
            && !_tracer.IsHidden(ground.PointBodyFixed, ground.Facet, camera.BandAt(seen.Y).Camera.PositionBodyFixed);
        return isShown ? (((int)Math.Floor(seen.Y + 0.5) - 1) * camera.Width) + (int)Math.Floor(seen.X + 0.5) - 1 : -1;
    }

    /// <summary>Sum of the directions of the pixels; zero if none shows ground.</summary>
    private Vector3D MeanDirection(int threads, CancellationToken cancellation)
    {
        Vector3D[] sums = new Vector3D[truth.Camera.Height];
        ReadPoints(threads, (row, point) => sums[row] += point.Normalized(), cancellation);
        return sums.Aggregate(default(Vector3D), (sum, row) => sum + row);
    }

    private (GroundProjection Projection, CellBox Box) PlaceOf(
        MapKind kind, Vector3D mean, double cell, int threads, CancellationToken cancellation)
    {
        SelenographicPoint centre = SelenographicPoint.Below(mean);
        GroundProjection[] choices = kind switch
        {
            MapKind.Equirectangular => [Of(0.0, 0.0), Of(0.0, Math.PI)], // the border of one lies in the middle of the other
            MapKind.PolarStereographic => [Of(Math.CopySign(0.5 * Math.PI, mean.Z), 0.0)],
            _ => [Of(Rounded(centre.Latitude), Rounded(centre.Longitude))],
        };
        return choices.Select(projection => (projection, BoxOf(projection, cell, threads, cancellation)))
            .MinBy(choice => choice.Item2.Samples);

        GroundProjection Of(double latitude, double longitude) => new(kind, latitude, longitude, terrain.ReferenceRadius);
    }

    /// <summary>The cells in which the points of the pixels lie.</summary>
    private CellBox BoxOf(GroundProjection projection, double cell, int threads, CancellationToken cancellation)
    {
        CellBox[] rows = new CellBox[truth.Camera.Height];
        Array.Fill(rows, CellBox.Empty);
        ReadPoints(
            threads,
            (row, point) =>
            {
                (double x, double y) = projection.ToMap(point) ?? throw new BadInputException(
                    projection.Kind == MapKind.PolarStereographic
                        ? "--map: the image shows ground on both sides of the equator, a polar map only one side. Choose another map."
                        : "--map: the image shows ground more than 90 degrees from its middle, the map does not. Choose another map.");
                rows[row] = rows[row].With((long)Math.Floor(x / cell), (long)Math.Floor(-y / cell));
            },
            cancellation);
        return rows.Aggregate(CellBox.Empty, (all, row) => row.Samples <= 0 ? all
            : all.With(row.Left, row.Top).With(row.Right - 1, row.Bottom - 1));
    }

    /// <summary>Grows a map until its border shows nothing.</summary>
    private CellBox Grown(CellBox box, GroundProjection projection, double cell, int threads, CancellationToken cancellation)
    {
        while (true)
        {
            if ((double)box.Lines * box.Samples > MaxCells)
            {
                throw new BadInputException(Invariant(
                    $"--map: {box.Lines} x {box.Samples} cells of {cell:R} m are needed; {MaxCells} cells are the limit. Choose wider "
                        + $"ones."));
            }

            long across = Math.Max(1, box.Samples / Growth);
            long down = Math.Max(1, box.Lines / Growth);
            CellBox grown = new(
                box.Left - (IsSeen(box with { Right = box.Left + 1 }) ? across : 0),
                box.Top - (IsSeen(box with { Bottom = box.Top + 1 }) ? down : 0),
                box.Right + (IsSeen(box with { Left = box.Right - 1 }) ? across : 0),
                box.Bottom + (IsSeen(box with { Top = box.Bottom - 1 }) ? down : 0));
            if (grown == box)
            {
                return box;
            }

            box = grown;
        }

        bool IsSeen(CellBox cells)
        {
            bool isSeen = false;
            WorkerTeam.Run(
                threads,
                (int)(cells.Lines * cells.Samples),
                (_, index) =>
                {
                    // Only ever set: "isSeen |=" would write back what it read before another thread saw something.
                    if (!Volatile.Read(ref isSeen)
                        && PixelOf(projection, cell, cells.Top + (index / cells.Samples), cells.Left + (index % cells.Samples)) >= 0)
                    {
                        Volatile.Write(ref isSeen, true);
                    }
                },
                cancellation);
            return isSeen;
        }
    }

    /// <summary>Leaves lines and columns out at whose side nothing is seen.</summary>
    private ImageMap Cut(GroundProjection projection, double cell, CellBox box, int[] pixels)
    {
        CellBox shown = CellBox.Empty;
        for (int index = 0; index < pixels.Length; index++)
        {
            shown = pixels[index] < 0 ? shown : shown.With(box.Left + (index % box.Samples), box.Top + (index / box.Samples));
        }

        if (shown.Samples <= 0)
        {
            throw new BadInputException(Invariant($"--map: the image shows the middle of no cell of {cell:R} m. Choose smaller ones."));
        }

        int[] kept = new int[shown.Lines * shown.Samples];
        for (int line = 0; line < shown.Lines; line++)
        {
            long start = ((shown.Top - box.Top + line) * box.Samples) + shown.Left - box.Left;
            pixels.AsSpan((int)start, (int)shown.Samples).CopyTo(kept.AsSpan(line * (int)shown.Samples));
        }

        MapGrid grid = new(
            projection, (int)shown.Lines, (int)shown.Samples, shown.Left * cell, -shown.Top * cell, cell, cell);
        return new ImageMap(grid, truth.Camera.Width * truth.Camera.Height, kept);
    }

    private void ReadPoints(int threads, Action<int, Vector3D> use, CancellationToken cancellation)
    {
        TruthRow[] rows = [.. Enumerable.Range(0, threads).Select(_ => new TruthRow())];
        WorkerTeam.Run(
            threads,
            truth.Camera.Height,
            (worker, row) =>
            {
                truth.ReadRow(row + 1, rows[worker]);
                for (int i = 0; i < rows[worker].Points.Count; i++)
                {
                    use(row, rows[worker].PointAt(i));
                }
            },
            cancellation);
    }

    private static double Rounded(double angle) =>
        double.DegreesToRadians(Math.Round(double.RadiansToDegrees(angle), CentreDigits));

    /// <summary>Cells from left to right and from the top downwards; the last ones are not part of it.</summary>
    private readonly record struct CellBox(long Left, long Top, long Right, long Bottom)
    {
        public static CellBox Empty { get; } = new(long.MaxValue, long.MaxValue, long.MinValue, long.MinValue);

        public long Samples => Right < Left ? 0 : Right - Left;

        public long Lines => Bottom < Top ? 0 : Bottom - Top;

        public CellBox With(long sample, long line) => new(
            Math.Min(Left, sample), Math.Min(Top, line), Math.Max(Right, sample + 1), Math.Max(Bottom, line + 1));
    }
}

/// <summary>Which pixel of an image each cell of a map shows. Cells have their borders at multiples of their width.</summary>
/// <param name="Grid">The cells.</param>
/// <param name="Pixels">
/// Line by line from the top: the pixel, counted by rows of the image from 0, in which the ground in the cell's middle is seen; -1 where
/// the image does not show it.
/// </param>
public sealed record ImageMap(MapGrid Grid, int ImagePixels, int[] Pixels);
