using Msisf.Adapters.Input;
using Msisf.Core.Detector;

namespace Msisf.Adapters.Camera;

/// <summary>Reads the keys of a detector's shutter.</summary>
internal static class ShutterKeys
{
    private const string Kind = "shutter";
    private const string LineTime = "line-time";
    private const string Step = "motion-step";
    private const string Rolling = "rolling";
    private const double MinStep = 0.01; // px
    private const double MaxStep = 1.0; // px

    public static string[] Keys { get; } = [Kind, LineTime, Step];

    /// <summary>Reads the shutter; null if there is none, so that frames are exposed at an instant.</summary>
    /// <exception cref="BadInputException">What is wrong, by file, line and column.</exception>
    public static Shutter? Read(SettingsSection section)
    {
        DetectorSection.RequireWith(section, LineTime, Kind);
        DetectorSection.RequireWith(section, Step, Kind);
        if (section.Word(Kind, ["global", Rolling]) is not string kind)
        {
            return null;
        }

        double? lineTime = section.Positive(LineTime);
        if (kind == Rolling && lineTime is null)
        {
            throw section.Wrong(Kind, $"a rolling shutter needs '{LineTime}': the time in s from the exposure of a row to the next");
        }

        return kind == Rolling || lineTime is null
            ? new Shutter
            {
                LineTime = lineTime ?? 0.0,
                MaxStep = DetectorSection.Range(section, Step, MinStep, MaxStep) ?? Shutter.DefaultMaxStep,
            }
            : throw section.Wrong(LineTime, $"'{LineTime}' has no meaning with a global shutter. Leave it out, or make it {Rolling}");
    }
}
