using Msisf.Core.Metadata;

namespace Msisf.Adapters.Maps;

/// <summary>What a map was made by and from.</summary>
/// <param name="Version">Version of the program.</param>
/// <param name="Command">The arguments that decide what the map holds.</param>
/// <param name="Inputs">The files.</param>
public sealed record MapOrigin(string Version, string Command, IReadOnlyList<InputFile> Inputs)
{
    /// <summary>The same as keys and texts: a list of files is separated by semicolons.</summary>
    public IEnumerable<(string Key, string Value)> Items
    {
        get
        {
            yield return ("CREATOR", $"MSISF {Version}");
            yield return ("COMMAND", Command);
            foreach (IGrouping<string, InputFile> files in Inputs.GroupBy(KeyOf))
            {
                yield return (files.Key, string.Join("; ", files.Select(file => file.Text)));
            }
        }
    }

    private static string KeyOf(InputFile file) => file.Kind switch
    {
        InputKind.ElevationLabel or InputKind.ElevationImage => "MODELS",
        InputKind.Kernel => "KERNELS",
        _ => "INPUTS",
    };
}
