using Msisf.Core.Attitude;
using Msisf.Core.Orbit;
using Msisf.Core.Time;

namespace Msisf.Adapters.Input;

/// <summary>How the numbers of a batch file are meant, where its columns do not say it; null is what is not said.</summary>
public sealed record BatchConventions
{
    /// <summary>Words for <see cref="Frame"/>.</summary>
    public static (string Word, OrbitFrame Value)[] Frames { get; } =
        [("moon-me", OrbitFrame.MoonMe), ("moon-me-epoch", OrbitFrame.MoonMeEpoch), ("j2000", OrbitFrame.J2000)];

    /// <summary>Words for <see cref="Axes"/>.</summary>
    public static (string Word, CameraAxes Value)[] CameraAxesWords { get; } =
        [("camera", CameraAxes.Camera), ("opencv", CameraAxes.OpenCv)];

    /// <summary>Words for <see cref="Rotation"/>.</summary>
    public static (string Word, RotationDirection Value)[] Rotations { get; } =
        [("from-camera", RotationDirection.FromCamera), ("to-camera", RotationDirection.ToCamera)];

    /// <summary>Frame of positions and attitudes.</summary>
    public OrbitFrame? Frame { get; init; }

    /// <summary>Axes of the camera in which its attitudes are given.</summary>
    public CameraAxes? Axes { get; init; }

    /// <summary>Which way quaternions and matrices turn vectors.</summary>
    public RotationDirection? Rotation { get; init; }

    /// <summary>Sequence of the Euler angles.</summary>
    public EulerSequence? Euler { get; init; }

    /// <summary>From when on seconds are counted, and of the frame that is held still, UTC.</summary>
    public CalendarTime? Epoch { get; init; }

    /// <summary>Whether columns that are not known are left out.</summary>
    public bool IgnoresColumns { get; init; }

    /// <summary>Whether quaternions and matrices may be rounded to a few decimals.</summary>
    public bool Normalizes { get; init; }
}

/// <summary>Reads the comment of a batch file that says how its numbers are meant: <c># msis: frame=j2000 axes=opencv</c>.</summary>
internal static class BatchKeyLine
{
    private const string Mark = "msis:";

    private static readonly string[] Keys = ["frame", "axes", "rotation", "euler", "epoch"];

    /// <summary>Whether a comment is such a line.</summary>
    /// <param name="comment">What is behind "#".</param>
    public static bool IsOne(ReadOnlySpan<char> comment) => comment.Trim().StartsWith(Mark, StringComparison.OrdinalIgnoreCase);

    /// <summary>Adds what the line says to what is said already.</summary>
    /// <param name="comment">What is behind "#".</param>
    /// <param name="said">By the options, or by another such line.</param>
    /// <exception cref="BadInputException">A key is unknown or said twice, or a value is wrong.</exception>
    public static BatchConventions Add(ReadOnlySpan<char> comment, BatchConventions said)
    {
        string text = comment.Trim()[Mark.Length..].ToString();
        foreach (string word in text.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries))
        {
            string[] parts = word.Split('=', 2);
            string key = parts[0].ToLowerInvariant();
            if (!Keys.Contains(key))
            {
                throw new BadInputException(
                    $"{NumberText.Shown(parts[0])} is not a key of a '# msis:' line{NearestName.Question(key, Keys, ".")} There are "
                        + $"{string.Join(", ", Keys)}, as in '# msis: frame=j2000'.");
            }

            if (parts.Length == 1 || parts[1].Length == 0)
            {
                throw new BadInputException($"'{key}' has no value; write {key}=VALUE, without blanks.");
            }

            said = With(said, key, parts[1]);
        }

        return said;
    }

    private static BatchConventions With(BatchConventions said, string key, string value)
    {
        object? before = key switch
        {
            "frame" => said.Frame,
            "axes" => said.Axes,
            "rotation" => said.Rotation,
            "euler" => said.Euler,
            _ => said.Epoch,
        };
        if (before is not null)
        {
            throw new BadInputException(
                $"'{key}' is said twice: here, and before or by {(key == "epoch" ? "--epoch" : $"--batch-{key}")}. Remove one.");
        }

        return key switch
        {
            "frame" => said with { Frame = ValueOf(key, value, BatchConventions.Frames) },
            "axes" => said with { Axes = ValueOf(key, value, BatchConventions.CameraAxesWords) },
            "rotation" => said with { Rotation = ValueOf(key, value, BatchConventions.Rotations) },
            "euler" => said with { Euler = EulerSequence.Parse(value) },
            _ => said with { Epoch = TimeText.Parse(value) },
        };
    }

    private static T ValueOf<T>(string key, string value, IReadOnlyList<(string Word, T Value)> words)
    {
        foreach ((string word, T meant) in words)
        {
            if (word.Equals(value, StringComparison.OrdinalIgnoreCase))
            {
                return meant;
            }
        }

        throw new BadInputException(
            $"'{key}' is {NumberText.Shown(value)}; one of {string.Join(", ", words.Select(pair => pair.Word))} is needed.");
    }
}
