using Msisf.Core.Numerics;
using Msisf.Core.Parallel;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Reads the receivers of a frame, chooses light space for them and sorts them into a grid. Only their bins are kept from the first reading
/// to the sorting: what is sorted is computed again, which is as quick as to fetch it from memory.
/// </summary>
internal sealed class ReceiverSort : IReceiverBounds
{
    /// <summary>Spacing, in rows of the image, of the rows that are read first to choose light space and its bins.</summary>
    private const int ScoutSpacing = 16;

    /// <summary>Maximum number of groups of rows sorted at the same time; limits memory, because each group counts every bin.</summary>
    private const int MaxParts = 8;

    private readonly List<ReceiverRow> _scouts = [];
    private readonly List<ReceiverRow> _scratch = [];
    private LightBox[] _boxes = [];

    /// <summary>The sorted receivers, without those in the night zone.</summary>
    public ReceiverGrid Grid { get; } = new();

    /// <summary>Light space of the frame.</summary>
    public LightFrame Frame { get; private set; } = null!;

    /// <summary>Bounds of all receivers in the grid, m; empty if there are none.</summary>
    public LightBox Box { get; private set; }

    /// <inheritdoc/>
    public double MaxDepth => Grid.MaxDepth();

    /// <inheritdoc/>
    public double MaxDepthIn(in LightBox box) => Grid.MaxDepth(Grid.BinsOf(in box));

    /// <summary>Reads the receivers and finds their number and maximum depth in each bin of the grid.</summary>
    /// <param name="receivers">The points that may be lit.</param>
    /// <param name="sun">The Sun.</param>
    /// <param name="night">The zone in which every point is in shadow.</param>
    /// <param name="hide">Called with each pixel in the night zone, from several threads.</param>
    /// <param name="threads">Maximum number of threads.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void Read(
        IReceiverRows receivers, LightSource sun, NightZone night, Action<int> hide, int threads, CancellationToken cancellation)
    {
        int rows = receivers.Rows;
        if (_boxes.Length < rows)
        {
            _boxes = new LightBox[rows];
        }

        Scout(receivers, sun, threads, cancellation);
        RunParts(receivers, threads, (part, row) =>
        {
            bool isScout = row % ScoutSpacing == 0;
            ReceiverRow points = isScout ? _scouts[row / ScoutSpacing] : _scratch[part];
            if (!isScout)
            {
                points.Read(receivers, row);
                points.ToLight(Frame);
            }

            _boxes[row] = CountRow(points, receivers, row, part, night, dark: null, hide);
        }, cancellation);
        Place(rows);
    }

    /// <summary>Leaves out the receivers in a further zone; they count as those in the night zone.</summary>
    /// <param name="receivers">The same receivers as in <see cref="Read"/>, which must have had the same number of threads.</param>
    /// <param name="dark">The zone.</param>
    /// <param name="night">The same zone as in <see cref="Read"/>.</param>
    /// <param name="hide">Called with each pixel in one of the zones, from several threads.</param>
    /// <param name="threads">The same number of threads as in <see cref="Read"/>.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void LeaveOut(
        IReceiverRows receivers, DarkZone dark, NightZone night, Action<int> hide, int threads, CancellationToken cancellation)
    {
        Grid.WantAll();
        Grid.Lay(Box, Grid.Length, PartsOf(threads), Start(receivers, receivers.Rows));
        RunParts(receivers, threads, (part, row) =>
        {
            ReceiverRow points = ReadMarked(receivers, row, part);
            _boxes[row] = CountRow(points, receivers, row, part, night, dark, hide);
        }, cancellation);
        Place(receivers.Rows);
    }

    /// <summary>Sorts the receivers into the bins of the grid that are marked.</summary>
    /// <param name="receivers">The same receivers as in <see cref="Read"/>, which must have had the same number of threads.</param>
    /// <param name="threads">Maximum number of threads.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void Sort(IReceiverRows receivers, int threads, CancellationToken cancellation)
    {
        Grid.MakeRoom();
        RunParts(receivers, threads, (part, row) =>
        {
            Grid.Sort(ReadMarked(receivers, row, part), Start(receivers, row), part, row * receivers.Width);
        }, cancellation);
    }

    private static int PartsOf(int threads) => Math.Min(threads, MaxParts);

    /// <summary>Where a row begins among the columns of all rows.</summary>
    private static int Start(IReceiverRows receivers, int row) => row * ReceiverRow.Padded(receivers.Width);

    /// <summary>Does something with each row; the rows of a part from top to bottom.</summary>
    private static void RunParts(IReceiverRows receivers, int threads, Action<int, int> work, CancellationToken cancellation)
    {
        int parts = PartsOf(threads);
        WorkerTeam.Run(threads, parts, (_, part) =>
        {
            for (int row = part; row < receivers.Rows; row += parts)
            {
                cancellation.ThrowIfCancellationRequested();
                work(part, row);
            }
        }, cancellation);
    }

    private LightBox CountRow(
        ReceiverRow points, IReceiverRows receivers, int row, int part, NightZone night, DarkZone? dark, Action<int> hide)
    {
        int firstPixel = row * receivers.Width;
        return Grid.Count(points, Start(receivers, row), part, night, dark, column => hide(firstPixel + column));
    }

    private ReceiverRow ReadMarked(IReceiverRows receivers, int row, int part)
    {
        ReceiverRow points = _scratch[part];
        points.ReadMarked(receivers, row, Grid, Start(receivers, row));
        points.ToLight(Frame);
        return points;
    }

    private void Place(int rows)
    {
        Grid.Place();
        Box = LightBox.Empty;
        for (int row = 0; row < rows; row++)
        {
            Box = LightBox.Union(Box, _boxes[row]);
        }
    }

    /// <summary>Chooses light space and its bins from some of the rows; a poor choice makes the frame slower but not wrong.</summary>
    private void Scout(IReceiverRows receivers, LightSource sun, int threads, CancellationToken cancellation)
    {
        int scouts = (receivers.Rows + ScoutSpacing - 1) / ScoutSpacing;
        while (_scouts.Count < scouts)
        {
            _scouts.Add(new ReceiverRow());
        }

        while (_scratch.Count < PartsOf(threads))
        {
            _scratch.Add(new ReceiverRow());
        }

        WorkerTeam.Run(threads, scouts, (_, scout) => _scouts[scout].Read(receivers, scout * ScoutSpacing), cancellation);
        Vector3D sum = default;
        int count = 0;
        for (int scout = 0; scout < scouts; scout++)
        {
            sum += _scouts[scout].Sum();
            count += _scouts[scout].Count;
        }

        Frame = new LightFrame(sun.PositionMoonMe, sum);
        LightBox box = LightBox.Empty;
        for (int scout = 0; scout < scouts; scout++)
        {
            _scouts[scout].ToLight(Frame);
            box = LightBox.Union(box, _scouts[scout].Box());
        }

        Grid.Lay(box.IsEmpty ? default : box, count * ScoutSpacing, PartsOf(threads), Start(receivers, receivers.Rows));
    }
}
