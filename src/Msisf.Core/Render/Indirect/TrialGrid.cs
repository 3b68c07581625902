namespace Msisf.Core.Render.Indirect;

/// <summary>What the samples of all groups of points have shown, and how many more they need.</summary>
/// <param name="groups">Groups of a strip.</param>
/// <param name="strips">Number of strips.</param>
internal sealed class TrialGrid(int groups, int strips)
{
    /// <summary>How far the groups are whose samples tell how unsure a group is, if its own happen to agree.</summary>
    private const int Neighbours = 2;

    /// <summary>How often the bounds of the effort, a factor of four apart, are brought nearer to each other: to a thousandth.</summary>
    private const int Halvings = 12;

    /// <summary>Most effort: with it all groups have the most samples, however little light there is.</summary>
    private const double MostEffort = 1e15;

    private readonly Trial[] _own = new Trial[groups * strips];
    private readonly Trial[] _known = new Trial[groups * strips];

    /// <summary>What the samples of a group have shown.</summary>
    public ref Trial this[int strip, int group] => ref _own[(strip * groups) + group];

    /// <summary>The same, but no surer than the groups around it together, from the last time that these were looked at.</summary>
    public Trial Known(int strip, int group) => _known[(strip * groups) + group];

    /// <summary>Looks at the groups around each.</summary>
    public void LookAround()
    {
        for (int group = 0; group < _own.Length; group++)
        {
            _known[group] = Around(group);
        }
    }

    /// <summary>The effort with which the squares of all errors have a sum; 0 if they have less already.</summary>
    public double EffortFor(double allowed)
    {
        if (ErrorsWith(0.0) <= allowed)
        {
            return 0.0;
        }

        (double low, double high) = (0.0, 1.0);
        while (high < MostEffort && ErrorsWith(high) > allowed)
        {
            (low, high) = (high, 4.0 * high);
        }

        for (int i = 0; i < Halvings; i++)
        {
            double middle = 0.5 * (low + high);
            (low, high) = ErrorsWith(middle) > allowed ? (middle, high) : (low, middle);
        }

        return high;
    }

    /// <summary>What all groups' samples with an effort cost (<see cref="Trial.CostWith"/>).</summary>
    public double CostWith(double effort) => _known.Sum(trial => trial.CostWith(effort));

    private double ErrorsWith(double effort) => _known.Sum(trial => trial.Points * trial.ErrorWith(effort));

    private Trial Around(int group)
    {
        Trial own = _own[group];
        (double shared, double other, double bound, int count) = (0.0, 0.0, 0.0, 0);
        (int row, int column) = (group / groups, group % groups);
        for (int y = Math.Max(0, row - Neighbours); y <= Math.Min(row + Neighbours, (_own.Length / groups) - 1); y++)
        {
            for (int x = Math.Max(0, column - Neighbours); x <= Math.Min(column + Neighbours, groups - 1); x++)
            {
                ref readonly Trial near = ref _own[(y * groups) + x];
                shared += near.Points * near.Shared.OfOne * near.Shared.OfOne;
                other += near.Points * near.Other.OfOne * near.Other.OfOne;
                bound += near.Points * near.Bound;
                count += near.Points;
            }
        }

        return count == 0 ? own : own with
        {
            Shared = own.Shared with { OfOne = Math.Max(own.Shared.OfOne, Math.Sqrt(shared / count)) },
            Other = own.Other with { OfOne = Math.Max(own.Other.OfOne, Math.Sqrt(other / count)) },
            Bound = Math.Max(own.Bound, bound / count),
        };
    }
}
