using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Core.Attitude;

/// <summary>Attitudes from a file. Safe for several threads.</summary>
/// <param name="blocks">In the order of the file, each with at least one sample.</param>
/// <param name="bodyFromCamera">How the camera is mounted on the body whose attitudes the file has.</param>
/// <param name="source">The file's name, for messages.</param>
/// <param name="scale">Turns TDB into UTC, for messages.</param>
public sealed class SampledAttitude(
    IReadOnlyList<AttitudeBlock> blocks, UnitQuaternion bodyFromCamera, string source, TimeScale scale) : IAttitudeSource
{
    private readonly BlockTimes _times = new([.. blocks.Select(block => block.Samples.Cover)], source, scale);

    /// <inheritdoc/>
    public TdbCover Cover => _times.Cover;

    /// <inheritdoc/>
    public UnitQuaternion MoonFromCamera(in TrajectoryPoint point)
    {
        AttitudeBlock block = blocks[_times.Find(point.Tdb)];
        RotationMatrix moonFromFrame = block.MoonMeFromFrame ?? point.BodyFromJ2000;
        return UnitQuaternion.FromMatrix(moonFromFrame) * block.Samples.At(point.Tdb) * bodyFromCamera;
    }

    /// <inheritdoc/>
    public TurnRate? RateOf(in TrajectoryPoint point)
    {
        AttitudeBlock block = blocks[_times.Find(point.Tdb)];
        return block.Samples.RateAt(point.Tdb) is { } rate
            ? new TurnRate(bodyFromCamera.Conjugate * rate, IsOverBody: block.MoonMeFromFrame is not null)
            : null;
    }
}
