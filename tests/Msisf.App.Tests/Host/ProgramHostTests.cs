using Msisf.App.Host;
using Xunit;

namespace Msisf.App.Tests.Host;

public sealed class ProgramHostTests
{
    [Theory]
    [InlineData("XDG_CACHE_HOME=/x HOME=/h", "/x/msisf")]
    [InlineData("LOCALAPPDATA=/l HOME=/h", "/l/msisf/cache")] // Windows has data there too
    [InlineData("HOME=/h", "/h/.cache/msisf")]
    [InlineData("XDG_CACHE_HOME= HOME=/h", "/h/.cache/msisf")] // set, but empty
    [InlineData("", null)]
    public void CacheFolder_Environment_IsTheFirstFolderThatIsSet(string environment, string? folder)
    {
        Dictionary<string, string> variables = environment.Split(' ', StringSplitOptions.RemoveEmptyEntries)
            .Select(word => word.Split('=')).ToDictionary(pair => pair[0], pair => pair[1]);
        ProgramHost host = new(TimeProvider.System, variables.GetValueOrDefault)
        {
            Results = TextWriter.Null,
            Log = new ListLog(),
            Progress = null!, // nothing is shown
            StandardInput = () => TextReader.Null,
        };

        Assert.Equal(folder, host.CacheFolder);
    }
}
