function name = msisf_client_name()
% MSISF_CLIENT_NAME  A name of this program for the server, which shares itself evenly among the clients by their names.
    persistent made;
    if isempty(made)
        [~, made] = fileparts(tempname());
    end
    name = made;
end
