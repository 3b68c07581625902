using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Adapters.Ephemeris;

/// <summary>The attitude of an instrument in CKs and frame kernels.</summary>
public sealed class KernelAttitude : IAttitudeSource
{
    private readonly OpenedEphemeris _opened;
    private readonly string _frame;
    private readonly UnitQuaternion _instrumentFromCamera;

    /// <summary>Looks for the attitudes between the instrument and space.</summary>
    /// <param name="opened">The engine with its kernels.</param>
    /// <param name="axes">How the image lies in it.</param>
    /// <exception cref="BadInputException">The frame, a CK or a clock is missing.</exception>
    public KernelAttitude(OpenedEphemeris opened, string frame, InstrumentAxes axes)
    {
        (_opened, _frame, _instrumentFromCamera) = (opened, frame, axes.InstrumentFromCamera);
        Cover = TdbCover.Everything;
        foreach (int instrument in opened.Catalogue.Frames.AttitudesOf(frame))
        {
            TdbCover cover = opened.Catalogue.Attitudes.CoverOf(instrument);
            Cover = cover.Intervals.Count > 0
                ? Cover.Intersect(cover)
                : throw new BadInputException(
                    $"No CK has the attitude of {opened.Catalogue.Names.Describe(instrument)}, on which frame {frame} depends. "
                        + "Add its CK with --ck, or say how the camera points with --look-at or --attitude.");
        }
    }

    /// <inheritdoc/>
    public TdbCover Cover { get; }

    /// <inheritdoc/>
    /// <remarks>By the built-in reader, because CSPICE's frames take another segment where the first one has no rates.</remarks>
    public TurnRate? RateOf(in TrajectoryPoint point)
    {
        TdbTime time = Cover.InstantNear(point.Tdb.Seconds) ?? point.Tdb;
        FrameSystem frames = _opened.Catalogue.Frames;
        try
        {
            return frames.RateJ2000(_frame, time) is { } rate
                ? new TurnRate(_instrumentFromCamera.Conjugate * (frames.FrameFromJ2000(_frame, time) * rate), IsOverBody: false)
                : null;
        }
        catch (BadInputException)
        {
            return null; // a frame that only CSPICE knows
        }
    }

    /// <inheritdoc/>
    public UnitQuaternion MoonFromCamera(in TrajectoryPoint point)
    {
        // CSPICE's frames know no attitude at a single instant, because no time hits its tick; its reader of CKs has tolerances for that.
        double? instant = Cover.InstantNear(point.Tdb.Seconds);
        if (instant is null && !Cover.Contains(point.Tdb))
        {
            throw new BadInputException(
                $"{point.Time.ToIsoUtc()} is outside what the CKs have of frame {_frame}: "
                    + $"{new KernelCover(_opened.Engine.TimeScale, Cover).Describe()}. Choose a time inside, or other kernels.");
        }

        RotationMatrix moonFromInstrument =
            point.BodyFromJ2000 * (instant is { } at
                ? _opened.Catalogue.Frames.FrameFromJ2000(_frame, at)
                : _opened.Frames.FrameFromJ2000(_frame, point.Tdb)).Transposed;
        return UnitQuaternion.FromMatrix(moonFromInstrument) * _instrumentFromCamera;
    }
}
