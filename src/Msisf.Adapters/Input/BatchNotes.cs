using Msisf.Core.Attitude;

namespace Msisf.Adapters.Input;

/// <summary>Says how the columns of a batch file were understood, where a user may have meant something else.</summary>
internal static class BatchNotes
{
    private const double FullTurn = 2.0 * Math.PI;

    /// <summary>Writes all sentences that apply.</summary>
    /// <param name="file">The file, read to its end.</param>
    /// <param name="fileName">For the messages.</param>
    /// <param name="scene">Has the sphere over which heights are counted.</param>
    /// <param name="warn">Receives what is most likely not meant.</param>
    /// <param name="note">Receives what was understood in one of several ways.</param>
    public static void Write(BatchFileParser file, string fileName, ISceneGeometry scene, Action<string>? warn, Action<string>? note)
    {
        if (file is not { Columns: { } columns, ColumnStates: { } states })
        {
            return;
        }

        if (columns.Ignored.Count > 0)
        {
            note?.Invoke($"{fileName}: left out, as --ignore-columns says: {string.Join(", ", columns.Ignored)}.");
        }

        if (columns.Has(BatchNames.Altitude))
        {
            note?.Invoke(Invariant(
                $"{fileName}: column {BatchNames.Altitude} is taken as m over the sphere of {scene.ReferenceRadius:R} m; height takes "
                    + $"terrain+m, height_km kilometres."));
        }

        if (columns.Has(BatchNames.Motion[0]) && !columns.Has(BatchNames.Motion[3]))
        {
            note?.Invoke(
                $"{fileName}: the velocity {string.Join(", ", BatchNames.Motion[..3])} is not used: an image has no motion without "
                    + $"{string.Join(", ", BatchNames.Motion[3..])} and a camera with a shutter.");
        }

        if (states.GreatestEulerAngle is > 0.0 and <= FullTurn)
        {
            warn?.Invoke(Invariant(
                $"{fileName}: Euler angles are in degrees; none is above {states.GreatestEulerAngle:G3}. If they are radians, "
                    + $"convert them."));
        }

        if (states.HiddenTargets is [int first, ..] hidden)
        {
            string rest = hidden.Count switch
            {
                1 => string.Empty,
                2 => " So it is in 1 more line.",
                _ => $" So it is in {hidden.Count - 1} more lines.",
            };
            warn?.Invoke($"{fileName}, line {first}: the place to look at {PointingText.Hidden}{rest}");
        }
    }
}
