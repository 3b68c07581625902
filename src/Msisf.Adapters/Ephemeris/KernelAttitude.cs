using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;

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
    public UnitQuaternion MoonFromCamera(in TrajectoryPoint point)
    {
        if (!Cover.Contains(point.TdbSeconds))
        {
            throw new BadInputException(
                $"{point.Time.ToIsoUtc()} is outside what the CKs have of frame {_frame}: "
                    + $"{new KernelCover(_opened.Engine.TimeScale, Cover).Describe()}. Choose a time inside, or other kernels.");
        }

        RotationMatrix moonFromInstrument =
            point.BodyFromJ2000 * _opened.Frames.FrameFromJ2000(_frame, point.TdbSeconds).Transposed;
        return UnitQuaternion.FromMatrix(moonFromInstrument) * _instrumentFromCamera;
    }
}
