using Msisf.Core.Orbit;

namespace Msisf.Adapters.Input;

/// <summary>Refuses columns of a batch file that do not make a state, say a thing twice, or leave open how they are meant.</summary>
/// <param name="columns">The columns; null for a file without names, whose lines are states of eight numbers.</param>
/// <param name="said">How the numbers are meant.</param>
internal sealed class BatchRules(BatchColumns? columns, BatchConventions said)
{
    /// <summary>Checks all rules.</summary>
    /// <exception cref="BadInputException">The first one that is broken.</exception>
    public void Check()
    {
        if (columns is not null)
        {
            CheckPosition();
            CheckAttitude();
            bool hasRates = BatchNames.Motion[3..].Any(Has);
            RequireAll(hasRates ? BatchNames.Motion : BatchNames.Motion[..3]);
            RequireAll(BatchNames.Sun);
        }

        CheckConventions();
    }

    private void CheckPosition()
    {
        string[] times = [BatchNames.Time, BatchNames.Seconds];
        Require(times.Any(Has), "column time is missing: MJD or ISO 8601; or seconds, since --epoch.");
        Require(!times.All(Has), "time and seconds both say when. Remove one of them.");
        string[][] ways = [BatchNames.Place, [BatchNames.NamedPlace], BatchNames.Position, BatchNames.PositionKilometres];
        string[] heights = [.. BatchNames.Heights.Where(Has)];
        bool isOverGround = BatchNames.Place.Any(Has) || Has(BatchNames.NamedPlace);
        Require(
            ways.Count(way => way.Any(Has)) == 1 && (heights.Length == 0 || isOverGround),
            "a position is either lat, lon (or the name of a place) and a height (degrees; height in m over the sphere or terrain+m, "
                + "height_km or alt), or x, y, z (m), or x_km, y_km, z_km. Name one of them.");
        foreach (string[] way in ways)
        {
            RequireAll(way);
        }

        Require(heights.Length <= 1, $"{string.Join(" and ", heights)} all say how high the camera is. Leave one.");
        Require(
            !isOverGround || heights.Length == 1,
            $"column height is missing: {(Has(BatchNames.NamedPlace) ? "place" : "lat, lon")}, height go together.");
    }

    private void CheckAttitude()
    {
        string[][] rotations = [BatchNames.Quaternion, BatchNames.Matrix, BatchNames.Euler];
        foreach (string[] group in rotations)
        {
            RequireAll(group);
        }

        RequireAll(BatchNames.Target);
        RequireWith(BatchNames.LookHeight, Has(BatchNames.LookAt) ? BatchNames.LookAt : BatchNames.Target[0]);
        RequireWith(BatchNames.Azimuth, BatchNames.OffNadir);
        string[] directions = [.. new[] { BatchNames.Target[0], BatchNames.LookAt, BatchNames.OffNadir }.Where(Has)];
        Require(
            directions.Length <= 1,
            $"{string.Join(" and ", directions)} both say where the camera looks. Remove one of them.");
        string[] others =
        [
            .. rotations.Select(group => group[0]), .. directions, BatchNames.Roll, BatchNames.Up,
        ];
        if (rotations.FirstOrDefault(group => Has(group[0])) is { } given)
        {
            Require(
                !others.Any(other => other != given[0] && Has(other)),
                $"{string.Join(", ", given)} already say how the camera points. Remove them, or "
                    + $"{others.FirstOrDefault(other => other != given[0] && Has(other))}.");
        }
    }

    /// <summary>What is said must have a meaning, and what needs to be said must be.</summary>
    private void CheckConventions()
    {
        bool hasEuler = Has(BatchNames.Euler[0]);
        bool hasRotation = columns is null || Has(BatchNames.Quaternion[0]) || Has(BatchNames.Matrix[0]);
        bool hasVector = columns is null || Has(BatchNames.Position[0]) || Has(BatchNames.PositionKilometres[0])
            || Has(BatchNames.Sun[0]);
        RequireMeaning("frame", said.Frame is null || hasVector || hasRotation || hasEuler, "no column is of a frame");
        RequireMeaning(
            "axes", said.Axes is null || hasRotation || hasEuler, "no quaternion, matrix or Euler angle says how the camera points");
        RequireMeaning("rotation", said.Rotation is null || hasRotation, "there is no quaternion and no matrix");
        RequireMeaning("euler", said.Euler is null || hasEuler, "there are no columns euler1, euler2, euler3");
        Require(
            !hasEuler || said.Euler is not null,
            "Euler angles need their sequence: '# msis: euler=ZYX' above the header, or --batch-euler ZYX.");
        Require(
            !Has(BatchNames.Seconds) || said.Epoch is not null, "column seconds needs the epoch from which they count: --epoch, or "
                + "'# msis: epoch=2024-01-19T12:00:00Z' above the header.");
        Require(
            said.Epoch is null || Has(BatchNames.Seconds) || said.Frame == OrbitFrame.MoonMeEpoch,
            "the epoch has no meaning: there is no column seconds, and the frame is not moon-me-epoch. Leave out --epoch, or epoch=.");
        Require(
            said.Frame is null or OrbitFrame.MoonMe || !HasMotion(),
            $"{string.Join(", ", BatchNames.Motion)} are those over the turning Moon, in frame moon-me only. Remove them, or change the "
                + "frame.");
        Require(columns is not null || !said.IgnoresColumns, "--ignore-columns has no meaning: the file names no columns. Leave it out.");
    }

    private bool HasMotion() => columns is not null && Has(BatchNames.Motion[3]);

    private bool Has(string name) => columns?.Has(name) == true;

    private void RequireAll(string[] group) => Require(
        !group.Any(Has) || group.All(Has),
        $"column {group.FirstOrDefault(column => !Has(column))} is missing: {string.Join(", ", group)} go together.");

    private void RequireWith(string column, string other) => Require(
        !Has(column) || Has(other), $"column {column} needs {other}. Add it, or remove {column}.");

    private static void RequireMeaning(string key, bool isRight, string why) => Require(
        isRight, $"'{key}' has no meaning: {why}. Leave out --batch-{key}, or {key}=.");

    private static void Require(bool isRight, string problem)
    {
        if (!isRight)
        {
            throw new BadInputException(problem);
        }
    }
}
