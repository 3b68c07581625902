using Msisf.Core.Ephemeris;

namespace Msisf.Core.Attitude;

/// <summary>Attitudes from a file. Safe for several threads.</summary>
public sealed class SampledAttitude : IAttitudeSource
{
    private readonly IReadOnlyList<AttitudeBlock> _blocks;
    private readonly BlockTimes _times;
    private readonly UnitQuaternion _bodyFromCamera;

    /// <summary>Takes the file's blocks.</summary>
    /// <param name="blocks">In the order of the file, each with at least one sample.</param>
    /// <param name="bodyFromCamera">How the camera is mounted on the body whose attitudes the file has.</param>
    /// <param name="source">The file's name, for messages.</param>
    /// <param name="scale">Turns TDB into UTC, for messages.</param>
    public SampledAttitude(IReadOnlyList<AttitudeBlock> blocks, UnitQuaternion bodyFromCamera, string source, TdbScale scale)
    {
        (_blocks, _bodyFromCamera) = (blocks, bodyFromCamera);
        _times = new BlockTimes([.. blocks.Select(block => block.Samples.Cover)], source, scale);
    }

    /// <inheritdoc/>
    public TdbCover Cover => _times.Cover;

    /// <inheritdoc/>
    public UnitQuaternion MoonFromCamera(in TrajectoryPoint point)
    {
        AttitudeBlock block = _blocks[_times.Find(point.TdbSeconds)];
        RotationMatrix moonFromFrame = block.MoonMeFromFrame ?? point.MoonMeFromJ2000;
        return UnitQuaternion.FromMatrix(moonFromFrame) * block.Samples.At(point.TdbSeconds) * _bodyFromCamera;
    }
}

/// <summary>A part of a file's attitudes, which are of one frame.</summary>
/// <param name="MoonMeFromFrame">
/// For a frame that turns with the Moon, the constant rotation to MOON_ME; null for J2000's axes.
/// </param>
public sealed record AttitudeBlock(AttitudeSamples Samples, RotationMatrix? MoonMeFromFrame);
