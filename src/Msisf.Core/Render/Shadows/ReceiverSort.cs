using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>Reads the receivers of a frame, lays out light space for them and sorts them into a grid.</summary>
internal sealed class ReceiverSort
{
    /// <summary>Every so many rows of the image are read first, to lay out light space.</summary>
    private const int ScoutSpacing = 16;

    /// <summary>The sort keeps a count of every bin for each part that it does at the same time.</summary>
    private const int MaxParts = 8;

    private readonly ReceiverRows _rows = new();
    private LightBox[] _boxes = [];

    /// <summary>The receivers; those deep in the night are left out.</summary>
    public ReceiverGrid Grid { get; } = new();

    /// <summary>Light space.</summary>
    public LightFrame Frame { get; private set; } = null!;

    /// <summary>All receivers are in it; empty if there are none.</summary>
    public LightBox Box { get; private set; }

    /// <summary>Reads the receivers and finds out how deep they are in each bin of the grid.</summary>
    /// <param name="receivers">Points that may be lit.</param>
    /// <param name="sun">The Sun.</param>
    /// <param name="night">Where it is dark for sure.</param>
    /// <param name="threads">At most.</param>
    /// <param name="cancellation">Ends the work.</param>
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

                _boxes[row] = Grid.Count(_rows, row, part, night);
            }
        }, cancellation);
        Grid.Place();
        Box = LightBox.Empty;
        for (int row = 0; row < rows; row++)
        {
            Box = LightBox.Union(Box, _boxes[row]);
        }
    }

    /// <summary>Sorts the receivers into the bins of the grid that are wanted.</summary>
    /// <param name="receivers">As they were read, with as many threads.</param>
    /// <param name="hide">Gets each pixel in the night; several threads call it.</param>
    /// <param name="threads">At most.</param>
    /// <param name="cancellation">Ends the work.</param>
    public void Sort(IReceiverRows receivers, Action<int> hide, int threads, CancellationToken cancellation)
    {
        int parts = Math.Min(threads, MaxParts);
        WorkerTeam.Run(threads, parts, (_, part) =>
        {
            for (int row = part; row < receivers.Rows; row += parts)
            {
                Grid.Sort(_rows, row, part, row * receivers.Width, hide);
            }
        }, cancellation);
    }

    /// <summary>Lays out light space by a part of the rows; a bad choice costs time only.</summary>
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
