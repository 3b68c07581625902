using Msisf.Adapters.IO;
using Msisf.Core.Errors;
using Msisf.Core.Tiles;

namespace Msisf.Adapters.Tiles;

/// <summary>A pattern that a scene needs.</summary>
/// <param name="Path">Its file.</param>
/// <param name="Layout">What its mesh joins.</param>
/// <param name="Builder">Makes the mesh.</param>
/// <param name="ProductId">The elevation model.</param>
/// <param name="Format">The form of the mesh.</param>
internal sealed record PatternOrder(string Path, TileMeshLayout Layout, TileMeshBuilder Builder, string ProductId, PatternFormat Format)
{
    /// <summary>Reads the samples, which say what the file must hold.</summary>
    /// <exception cref="BadInputException">The model is damaged.</exception>
    public Content Read()
    {
        double[] radii = Builder.ReadRadii(Layout);
        return new Content(this, radii, PatternHeader.WithoutLength(Layout, radii, Builder.SkirtFootRadius, ProductId, Format));
    }

    /// <summary>What the file of an order must hold.</summary>
    public sealed class Content(PatternOrder order, double[] radii, byte[] header)
    {
        /// <summary>Whether the file is there and complete; one read, whatever its size.</summary>
        /// <exception cref="BadInputException">The file is not of this program.</exception>
        /// <exception cref="ExternalPartException">The file is there but can't be read.</exception>
        public bool IsThere() => PatternFile.Inspect(order.Path, header) switch
        {
            PatternFile.State.Good => true,
            PatternFile.State.Foreign => throw new BadInputException(
                $"{order.Path}: has a pattern's name, but this program has not made it, so it stays as it is. "
                    + $"Move it away, or choose another pattern repository."),
            _ => false,
        };

        /// <summary>Makes the file.</summary>
        /// <param name="isClaimed">Whether no other process or thread can be making it.</param>
        /// <exception cref="ExternalPartException">The repository can't be written.</exception>
        public void Write(bool isClaimed)
        {
            TileMesh mesh = order.Builder.Build(order.Layout, radii);
            Action<string, Action<Stream>, bool> writeFile = isClaimed ? AtomicFile.WriteClaimed : AtomicFile.Write;
            // a power cut's short file is found by its header
            writeFile(order.Path, stream => PatternWriter.Write(stream, mesh, header, order.Format), false);
        }
    }
}
