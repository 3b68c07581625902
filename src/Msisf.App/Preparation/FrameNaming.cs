using System.Text;
using System.Text.RegularExpressions;
using Msisf.Adapters.IO;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>The file names of a run's frames, from a pattern such as "orbit_{step:00000}_{mjd:0.000000}".</summary>
internal sealed partial class FrameNaming
{
    /// <summary>
    /// Maximum length of a frame's name, bytes: file systems allow 255 bytes, and the rest is for ".annotated.png" and temporary names.
    /// </summary>
    private const int LongestName = 180;

    private readonly string _pattern;

    /// <param name="pattern">The pattern; of a rig that does not name the camera its name is put behind it.</param>
    /// <param name="camera">Name of the rig's camera; null without a rig.</param>
    /// <exception cref="UsageException">The pattern contains a folder, an unknown or unclosed field, or an invalid format.</exception>
    public FrameNaming(string pattern, string? camera = null)
    {
        if (camera is not null)
        {
            pattern = (pattern.Contains(RigOptions.CameraField, StringComparison.Ordinal) ? pattern : $"{pattern}_{RigOptions.CameraField}")
                .Replace(RigOptions.CameraField, camera, StringComparison.Ordinal);
        }

        _pattern = pattern;
        string literal = Field().Replace(pattern, string.Empty);
        if (literal.Contains('{') || literal.Contains('}'))
        {
            throw OutputOptions.Name.Wrong(
                $"{pattern}: a field is {{step}} or {{mjd}}, if need be with a number format, e.g. {{step:00000}}, and "
                    + $"{RigOptions.CameraField} with {RigOptions.Rig.Name}.");
        }

        if (pattern.Contains('/') || pattern.Contains('\\') || pattern.Any(char.IsControl) || pattern.Trim().Length == 0
            || pattern[0] == '.')
        {
            throw OutputOptions.Name.Wrong($"'{pattern}': a file name is needed, without folders; the folder is given by --output-dir.");
        }

        NameOf(1, 0.0);
    }

    /// <summary>The file name of one frame, without extension.</summary>
    /// <param name="step">Number of the step, from 1.</param>
    /// <param name="mjd">Time, UTC.</param>
    public string NameOf(int step, double mjd)
    {
        string name = Field().Replace(_pattern, field =>
        {
            string? format = field.Groups["format"].Success ? field.Groups["format"].Value : null;
            return field.Groups["name"].Value == "step"
                ? step.ToString(format, CultureInfo.InvariantCulture)
                : mjd.ToString(format ?? "R", CultureInfo.InvariantCulture);
        });
        if (OperatingSystem.IsWindows() && WindowsNames.FaultOf(name) is { } fault)
        {
            throw OutputOptions.Name.Wrong($"'{name}': {fault}. Choose another name.");
        }

        int bytes = Encoding.UTF8.GetByteCount(name);
        return bytes <= LongestName
            ? name
            : throw new UsageException($"--output-name: the name {name[..Math.Min(40, name.Length)]}... has {bytes} bytes; "
                + $"at most {LongestName} are possible.").About(OutputOptions.Name);
    }

    /// <exception cref="UsageException">Two frames would get one name.</exception>
    public IReadOnlyList<string> NamesOf(IReadOnlyList<Instant> times)
    {
        Dictionary<string, int> stepOfName = new(times.Count, StringComparer.OrdinalIgnoreCase);
        string[] names = new string[times.Count];
        for (int index = 0; index < names.Length; index++)
        {
            names[index] = NameOf(index + 1, times[index].Mjd);
            if (!stepOfName.TryAdd(names[index], index + 1))
            {
                throw OutputOptions.Name.Wrong(
                    $"{_pattern}: steps {stepOfName[names[index]]} and {index + 1} would both be written to {names[index]}. Add "
                        + $"{{step:00000}} to the pattern.");
            }
        }

        return names;
    }

    [GeneratedRegex(@"\{(?<name>step|mjd)(:(?<format>0+(\.0+)?))?\}")]
    private static partial Regex Field();
}
