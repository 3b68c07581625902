using Msisf.Core.Parallel;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Reads the receivers of a frame, chooses light space for them and sorts them into a grid. Only their bins are kept from the first reading
/// to the sorting: what is sorted is computed again, which is as quick as to fetch it from memory.
/// </summary>
internal sealed class ReceiverSort
{
    /// <summary>Spacing, in rows of the image, of the rows that are read first to choose light space and its bins.</summary>
    private const int ScoutSpacing = 16;

    private readonly ReceiverGrid _grid = new();
    private readonly List<ReceiverRow> _scouts = [];
    private readonly List<ReceiverRow> _scratch = [];
    private LightBox[] _boxes = [];

    /// <summary>Bytes of the arrays of receivers that were replaced since the first frame.</summary>
    public long ReplacedBytes => _grid.ReplacedBytes;

    /// <summary>Reads the receivers and finds their number and maximum depth in each bin of the grid.</summary>
    /// <param name="job">The receivers, and what to do with those that are dark.</param>
    /// <returns>Valid until the next frame.</returns>
    public PlacedReceivers Read(ReceiverJob job, LightSource sun)
    {
        if (_boxes.Length < job.Receivers.Rows)
        {
            _boxes = new LightBox[job.Receivers.Rows];
        }

        (LightFrame frame, ReceiverGrid.Counting counting) = Scout(job, sun);
        job.ForRows((part, row) =>
        {
            bool isScout = row % ScoutSpacing == 0;
            ReceiverRow points = isScout ? _scouts[row / ScoutSpacing] : _scratch[part];
            if (!isScout)
            {
                points.Read(job.Receivers, row);
                points.ToLight(frame);
            }

            CountRow(counting, job, points, row, part, dark: null);
        });
        return Place(counting, job, frame);
    }

    /// <summary>Leaves out the receivers in a further zone; they count as those in the night zone.</summary>
    internal PlacedReceivers LeaveOut(PlacedReceivers all, ReceiverGrid.Placed placed, ReceiverJob job, DarkZone dark)
    {
        placed.WantAll();
        ReceiverGrid.Counting counting = _grid.Lay(all.Box, all.Length, job.Parts, job.StartOf(job.Receivers.Rows));
        job.ForRows((part, row) => CountRow(counting, job, ReadMarked(all, placed, job, row, part), row, part, dark));
        return Place(counting, job, all.Frame);
    }

    /// <summary>Sorts the receivers into the bins of the grid that are marked.</summary>
    internal SortedReceivers Sort(PlacedReceivers all, ReceiverGrid.Placed placed, ReceiverJob job)
    {
        ReceiverGrid.Sorting sorting = placed.MakeRoom();
        job.ForRows((part, row) => sorting.Sort(
            ReadMarked(all, placed, job, row, part), job.StartOf(row), part, row * job.Receivers.Width));
        return sorting.Finish(all);
    }

    private void CountRow(ReceiverGrid.Counting counting, ReceiverJob job, ReceiverRow points, int row, int part, DarkZone? dark)
    {
        int firstPixel = row * job.Receivers.Width;
        _boxes[row] = counting.Count(points, job.StartOf(row), part, job.Night, dark, column => job.Hide(firstPixel + column));
    }

    private ReceiverRow ReadMarked(PlacedReceivers all, ReceiverGrid.Placed placed, ReceiverJob job, int row, int part)
    {
        ReceiverRow points = _scratch[part];
        points.ReadMarked(job.Receivers, row, placed, job.StartOf(row));
        points.ToLight(all.Frame);
        return points;
    }

    private PlacedReceivers Place(ReceiverGrid.Counting counting, ReceiverJob job, LightFrame frame)
    {
        ReceiverGrid.Placed placed = counting.Place();
        LightBox box = LightBox.Empty;
        for (int row = 0; row < job.Receivers.Rows; row++)
        {
            box = LightBox.Union(box, _boxes[row]);
        }

        return new PlacedReceivers(this, job, placed, frame, box);
    }

    /// <summary>Chooses light space and its bins from some of the rows; a poor choice makes the frame slower but not wrong.</summary>
    private (LightFrame Frame, ReceiverGrid.Counting Counting) Scout(ReceiverJob job, LightSource sun)
    {
        int scouts = (job.Receivers.Rows + ScoutSpacing - 1) / ScoutSpacing;
        while (_scouts.Count < scouts)
        {
            _scouts.Add(new ReceiverRow());
        }

        while (_scratch.Count < job.Parts)
        {
            _scratch.Add(new ReceiverRow());
        }

        WorkerTeam.Run(job.Threads, scouts, (_, scout) => _scouts[scout].Read(job.Receivers, scout * ScoutSpacing), job.Cancellation);
        Vector3D sum = default;
        int count = 0;
        for (int scout = 0; scout < scouts; scout++)
        {
            sum += _scouts[scout].Sum();
            count += _scouts[scout].Count;
        }

        LightFrame frame = new(sun.PositionBodyFixed, sum);
        LightBox box = LightBox.Empty;
        for (int scout = 0; scout < scouts; scout++)
        {
            _scouts[scout].ToLight(frame);
            box = LightBox.Union(box, _scouts[scout].Box());
        }

        return (frame, _grid.Lay(
            box.IsEmpty ? default : box, count * ScoutSpacing, job.Parts, job.StartOf(job.Receivers.Rows)));
    }
}

/// <summary>The receivers of a frame that are sorted.</summary>
/// <param name="Receivers">The points that may be lit.</param>
/// <param name="Night">The zone in which every point is in shadow.</param>
/// <param name="Hide">Called with each pixel in a dark zone, from several threads.</param>
/// <param name="Threads">Maximum number of threads.</param>
internal sealed record ReceiverJob(
    IReceiverRows Receivers, NightZone Night, Action<int> Hide, int Threads, CancellationToken Cancellation)
{
    /// <summary>Maximum number of groups of rows sorted at the same time; limits memory, because each group counts every bin.</summary>
    private const int MaxParts = 8;

    /// <summary>Number of groups of rows sorted at the same time.</summary>
    public int Parts => Math.Min(Threads, MaxParts);

    /// <summary>Where a row begins among the columns of all rows.</summary>
    public int StartOf(int row) => row * ReceiverRow.Padded(Receivers.Width);

    /// <summary>Does something with each part and row; the rows of a part from top to bottom.</summary>
    public void ForRows(Action<int, int> work) => WorkerTeam.Run(Threads, Parts, (_, part) =>
    {
        for (int row = part; row < Receivers.Rows; row += Parts)
        {
            Cancellation.ThrowIfCancellationRequested();
            work(part, row);
        }
    }, Cancellation);
}

/// <summary>The receivers of a frame without those in the night zone, counted but not sorted yet; valid until they are sorted.</summary>
/// <param name="sort">Sorts them.</param>
/// <param name="placed">Their bins.</param>
/// <param name="frame">Light space.</param>
/// <param name="box">Bounds of them, m; empty if there are none.</param>
internal sealed class PlacedReceivers(
    ReceiverSort sort, ReceiverJob job, ReceiverGrid.Placed placed, LightFrame frame, LightBox box) : IReceiverBounds
{
    public LightFrame Frame => frame;

    public LightBox Box => box;

    public double MaxDepth => Bins.Max();

    public DepthGrid Bins => placed.Bins;

    public int Length { get; } = placed.Length;

    public double MaxDepthIn(in LightBox box) => Bins.Max(Bins.BinsOf(in box));

    /// <summary>Marks bins, so that their receivers are sorted. Several threads may call it.</summary>
    public void Want(GridRange bins) => placed.Want(bins);

    /// <summary>Sorts the receivers of the marked bins.</summary>
    public SortedReceivers SortMarked() => sort.Sort(this, placed, job);

    public SortedReceivers Sort()
    {
        placed.WantAll();
        return SortMarked();
    }

    /// <summary>The receivers without those in a further zone, which count as those in the night zone.</summary>
    public PlacedReceivers LeaveOut(DarkZone dark) => sort.LeaveOut(this, placed, job, dark);
}
