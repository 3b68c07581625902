using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>Reads the receivers of a frame, chooses light space for them and sorts them into a grid.</summary>
internal sealed class ReceiverSort
{
    /// <summary>Spacing, in rows of the image, of the rows that are read first to choose light space and its bins.</summary>
    private const int ScoutSpacing = 16;

    /// <summary>Maximum number of groups of rows sorted at the same time; limits memory, because each group counts every bin.</summary>
    private const int MaxParts = 8;

    private readonly ReceiverRows _rows = new();
    private LightBox[] _boxes = [];

    /// <summary>The sorted receivers, without those in the night zone.</summary>
    public ReceiverGrid Grid { get; } = new();

    /// <summary>Light space of the frame.</summary>
    public LightFrame Frame { get; private set; } = null!;

    /// <summary>Bounds of all receivers in the grid, m; empty if there are none.</summary>
    public LightBox Box { get; private set; }

    /// <summary>Reads the receivers and finds their number and maximum depth in each bin of the grid.</summary>
    /// <param name="receivers">The points that may be lit.</param>
    /// <param name="sun">The Sun.</param>
    /// <param name="night">The zone in which every point is in shadow.</param>
    /// <param name="threads">Maximum number of threads.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void Read(IReceiverRows receivers, LightSource sun, NightZone night, int threads, CancellationToken cancellation)
    {
        int rows = receivers.Rows;
        int parts = Math.Min(threads, MaxParts);
        _rows.Prepare(rows, receivers.Width);
        if (_boxes.Length < rows)
        {
            _boxes = new LightBox[rows];
        }

        Scout(receivers, sun, threads, parts, cancellation);
        WorkerTeam.Run(threads, parts, (_, part) =>
        {
            for (int row = part; row < rows; row += parts)
            {
                cancellation.ThrowIfCancellationRequested();
                if (row % ScoutSpacing != 0)
                {
                    _rows.Read(receivers, row);
                    _rows.ToLight(Frame, row);
                }

                _boxes[row] = Grid.Count(_rows, row, part, night, dark: null);
            }
        }, cancellation);
        Place(rows);
    }

    /// <summary>Leaves out the receivers in a further zone; they count as those in the night zone.</summary>
    /// <param name="dark">The zone.</param>
    /// <param name="night">The same zone as in <see cref="Read"/>.</param>
    /// <param name="rows">Number of rows of the image.</param>
    /// <param name="threads">The same number of threads as in <see cref="Read"/>.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void LeaveOut(DarkZone dark, NightZone night, int rows, int threads, CancellationToken cancellation)
    {
        int parts = Math.Min(threads, MaxParts);
        Grid.Lay(Box, Grid.Length, parts, _rows.Start(rows));
        WorkerTeam.Run(threads, parts, (_, part) =>
        {
            for (int row = part; row < rows; row += parts)
            {
                _boxes[row] = Grid.Count(_rows, row, part, night, dark);
            }
        }, cancellation);
        Place(rows);
    }

    /// <summary>Sorts the receivers into the bins of the grid that are marked.</summary>
    /// <param name="receivers">The same receivers as in <see cref="Read"/>, which must have had the same number of threads.</param>
    /// <param name="hide">Called with each pixel in the night zone, from several threads.</param>
    /// <param name="threads">Maximum number of threads.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void Sort(IReceiverRows receivers, Action<int> hide, int threads, CancellationToken cancellation)
    {
        int parts = Math.Min(threads, MaxParts);
        Grid.MakeRoom();
        WorkerTeam.Run(threads, parts, (_, part) =>
        {
            for (int row = part; row < receivers.Rows; row += parts)
            {
                Grid.Sort(_rows, row, part, row * receivers.Width, hide);
            }
        }, cancellation);
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
    private void Scout(IReceiverRows receivers, LightSource sun, int threads, int parts, CancellationToken cancellation)
    {
        int scouts = (receivers.Rows + ScoutSpacing - 1) / ScoutSpacing;
        WorkerTeam.Run(threads, scouts, (_, scout) => _rows.Read(receivers, scout * ScoutSpacing), cancellation);
        Vector3D sum = default;
        int count = 0;
        for (int row = 0; row < receivers.Rows; row += ScoutSpacing)
        {
            sum += _rows.Sum(row);
            count += _rows.Count(row);
        }

        Frame = new LightFrame(sun.PositionMoonMe, sum);
        LightBox box = LightBox.Empty;
        for (int row = 0; row < receivers.Rows; row += ScoutSpacing)
        {
            _rows.ToLight(Frame, row);
            box = LightBox.Union(box, _rows.BoxOf(row));
        }

        Grid.Lay(box.IsEmpty ? default : box, count * ScoutSpacing, parts, _rows.Start(receivers.Rows));
    }
}
