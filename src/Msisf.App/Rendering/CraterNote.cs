using Msisf.App.Host;
using Msisf.Core.Navigation;

namespace Msisf.App.Rendering;

/// <summary>Counts the listed craters that are too small for the elevation model, and notes them once. Thread-safe.</summary>
/// <param name="cell">m: width of a cell of the finest model.</param>
internal sealed class CraterNote(double cell)
{
    /// <summary>Cells across a crater below which the model does not have its rim.</summary>
    private const double FewestCells = 4.0;

    private const double MetresPerKilometre = 1000.0;

    private readonly Lock _gate = new();
    private int _listed;
    private int _small;

    /// <summary>Takes the craters of a frame.</summary>
    public void Add(CratersOfFrame craters)
    {
        int small = craters.Views.Count(view => view.Crater.Diameter < FewestCells * cell);
        lock (_gate)
        {
            _listed += craters.Views.Count;
            _small += small;
        }
    }

    /// <summary>Writes the note, if there is something to note.</summary>
    public void Write(ILog log)
    {
        if (_small > 0)
        {
            log.Note(Invariant(
                $"{_small} of {_listed} listed craters are smaller than {FewestCells:R} cells of the model ")
                + Invariant($"({FewestCells * cell / MetresPerKilometre:0.##} km): the image does not show their rims. ")
                + "Use a finer model (msis fetch ldem), or a catalogue of larger craters.");
        }
    }
}
