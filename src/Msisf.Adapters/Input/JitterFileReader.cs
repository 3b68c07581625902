using Msisf.Core.Camera;

namespace Msisf.Adapters.Input;

/// <summary>
/// Reads files of jitter (docs/scanning-cameras.md): lines of seconds, roll, pitch and yaw (microradians), or lines of an axis, a frequency
/// (Hz), an amplitude (microradians) and a phase (rad). Blanks, tabs or commas are between the values; "#" begins a comment.
/// </summary>
public static class JitterFileReader
{
    private const double RadiansPerMicroradian = 1e-6;

    private static readonly (string Word, JitterAxis Axis)[] Axes =
        [("roll", JitterAxis.Roll), ("pitch", JitterAxis.Pitch), ("yaw", JitterAxis.Yaw)];

    /// <summary>Reads a file.</summary>
    /// <param name="fileName">For messages.</param>
    /// <exception cref="BadInputException">What is wrong in it, by file and line.</exception>
    public static Jitter Read(TextReader reader, string fileName)
    {
        BoundedLineReader lines = new(reader, fileName);
        List<JitterSine> sines = [];
        List<(double Seconds, Vector3D Angles)> samples = [];
        while (lines.TryRead(out ReadOnlySpan<char> line))
        {
            int comment = line.IndexOf('#');
            string[] words = (comment < 0 ? line : line[..comment]).ToString()
                .Split([' ', '\t', ',', '\r'], StringSplitOptions.RemoveEmptyEntries);
            if (words.Length == 0 || (words[0] == "seconds" && sines.Count + samples.Count == 0))
            {
                continue;
            }

            if (words.Length != 4)
            {
                throw Wrong($"{words.Length} values, 4 are needed: seconds, roll, pitch and yaw, or an axis, frequency, amplitude and "
                    + "phase");
            }

            if (Array.FindIndex(Axes, axis => axis.Word == words[0]) is int index and >= 0)
            {
                sines.Add(new JitterSine(
                    Axes[index].Axis, Number(words[1]), RadiansPerMicroradian * Number(words[2]), Number(words[3])));
            }
            else
            {
                double seconds = Number(words[0]);
                if (samples.Count > 0 && !(seconds > samples[^1].Seconds))
                {
                    throw Wrong($"{words[0]} s is not later than the line before. Put the lines in the order of their times");
                }

                samples.Add((seconds, RadiansPerMicroradian * new Vector3D(Number(words[1]), Number(words[2]), Number(words[3]))));
            }

            if (sines.Count > 0 && samples.Count > 0)
            {
                throw Wrong("a line of an axis with its sine and one of seconds can't be in one file. Choose one kind");
            }
        }

        return sines.Count + samples.Count == 0 ? throw new BadInputException($"{fileName}: no line of jitter is in it. Add one.")
            : samples.Count > 0 ? new Jitter(samples)
            : new Jitter(sines);

        BadInputException Wrong(string why) => new($"{fileName}, line {lines.LineNumber}: {why}.");

        double Number(string text) => NumberText.TryParse(text, out double value) ? value : throw Wrong(NumberText.ProblemWith(text));
    }
}
