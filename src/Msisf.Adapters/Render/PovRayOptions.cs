namespace Msisf.Adapters.Render;

/// <summary>The user's own POV-Ray options.</summary>
public static class PovRayOptions
{
    /// <summary>What the program sets itself: input, output, size, file type, library path, threads.</summary>
    private static readonly string[] Reserved =
    [
        "Input_File_Name", "Output_File_Name", "Output_To_File", "Output_File_Type", "Width", "Height", "Library_Path", "Work_Threads",
        "Display", "Clock", "Initial_", "Final_", "Subset_", "Start_", "End_", "Continue_Trace", "Include_Header", "Cyclic_Animation",
        "Frame_Step", "Field_",
    ];

    private static readonly string[] ReservedSwitches =
    [
        "W", "WT", "H", "HI", "L", "D", "C", "S", "SC", "SR", "SF", "E", "EC", "ER", "EF", "K", "KC", "KF", "KI", "KFF", "KFI"
    ];

    /// <summary>Switches whose value follows at once and may begin with a letter: +Iname, +Oname, +FN16.</summary>
    private static readonly char[] ReservedLetters = ['I', 'O', 'F'];

    /// <summary>Splits the option text at white space.</summary>
    /// <param name="text">E.g. "Antialias=Off +Q9".</param>
    /// <exception cref="UsageException">An option that would take over what msis sets itself, or that is none.</exception>
    public static IReadOnlyList<string> Parse(string text)
    {
        string[] options = text.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
        foreach (string option in options)
        {
            bool isSwitch = option[0] is '+' or '-';
            if (isSwitch ? IsReservedSwitch(option[1..]) : IsReservedSetting(option))
            {
                throw new UsageException(
                    $"--pov-options: {option} is set by msis itself. Use --width, --height, --output-dir, --output-name, "
                        + $"--pattern-repos or --jobs.");
            }

            if (!isSwitch && !option.Contains('='))
            {
                throw new UsageException($"--pov-options: '{option}' is not a POV-Ray option: a switch (+Q9, -A) or Name=Value is needed.");
            }
        }

        return options;
    }

    private static bool IsReservedSetting(string option) =>
        Reserved.Any(name => option.StartsWith(name, StringComparison.OrdinalIgnoreCase));

    private static bool IsReservedSwitch(string body)
    {
        string letters = string.Concat(body.TakeWhile(char.IsAsciiLetter));
        return letters.Length == 0
            || ReservedSwitches.Contains(letters, StringComparer.OrdinalIgnoreCase)
            || ReservedLetters.Contains(char.ToUpperInvariant(letters[0]));
    }
}
