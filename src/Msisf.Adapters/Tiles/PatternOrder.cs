using Msisf.Adapters.IO;

namespace Msisf.Adapters.Tiles;

/// <summary>A pattern that a scene needs.</summary>
/// <param name="path">Its file.</param>
internal abstract class PatternOrder(string path)
{
    /// <summary>Its file.</summary>
    public string Path => path;

    /// <summary>Reads the model, which says what the file must hold.</summary>
    /// <exception cref="BadInputException">The model is damaged.</exception>
    public abstract Content Read();

    /// <summary>What the file of an order must hold.</summary>
    /// <param name="header">Its header, without the length (<see cref="PatternHeader"/>).</param>
    /// <param name="makeWriter">Makes what writes the whole file.</param>
    public sealed class Content(string path, byte[] header, Func<Action<Stream>> makeWriter)
    {
        /// <summary>Whether the file is there and complete; one read, whatever its size.</summary>
        /// <exception cref="BadInputException">The file is not of this program.</exception>
        /// <exception cref="ExternalPartException">The file is there but can't be read.</exception>
        public bool IsThere() => PatternFile.Inspect(path, header) switch
        {
            PatternFile.State.Good => true,
            PatternFile.State.Foreign => throw new BadInputException(
                $"{path}: has a pattern's name, but this program has not made it, so it stays as it is. "
                    + $"Move it away, or choose another pattern repository."),
            _ => false,
        };

        /// <summary>Makes the file.</summary>
        /// <param name="isClaimed">Whether no other process or thread can be making it.</param>
        /// <exception cref="ExternalPartException">The repository can't be written.</exception>
        public void Write(bool isClaimed)
        {
            Action<Stream> write = makeWriter();
            Action<string, Action<Stream>, bool> writeFile = isClaimed ? AtomicFile.WriteClaimed : AtomicFile.Write;
            writeFile(path, write, false); // a power cut's short file is found by its header
        }
    }
}
